#include "ui/kit/style.h"

#include "core/scene/palette.h"

#include <glm/common.hpp>

#include <cmath>

namespace normalscope {

namespace {

// Text between black and white, opaque.
ImVec4 faded_to(const ImVec4& text, float share) {
    const float v = text.x > 0.5f ? share : 1.0f - share;
    return {v, v, v, 1.0f};
}

void set_colors(Look& look) {
    const auto hex = [](unsigned v) { return to_imgui(rgb(v)); };
    const ThemeColors theme = theme_colors(look.theme);
    look.text = to_imgui(theme.text);
    look.panel = to_imgui(theme.panel);
    if (is_dark(look.theme)) {
        look.dim = hex(0x9AA1AB);
        look.card = hex(0x282C32);
        look.field = hex(0x343941);
        look.line = hex(0x3C424B);
        look.accent = hex(0xDDE1E6);
        look.on_accent = hex(0x1B1E22);
        look.good = hex(0x3CC79C);
        look.bad = hex(0xF0803A);
    } else {
        look.dim = hex(0x69707A);
        look.card = hex(0xF5F5F4);
        look.field = hex(0xE8E9EA);
        look.line = hex(0xDCDEE0);
        look.accent = hex(0x39414B);
        look.on_accent = hex(0xFFFFFF);
        look.good = hex(0x007A59);
        look.bad = hex(0xB84A00);
    }
    if (!has_contrast(look.theme)) return;
    look.dim = faded_to(look.text, is_dark(look.theme) ? 0.82f : 0.72f);
    look.card = is_dark(look.theme) ? hex(0x101214) : hex(0xFFFFFF);
    look.field = is_dark(look.theme) ? hex(0x2A2E33) : hex(0xE2E4E6);
    look.line = is_dark(look.theme) ? hex(0x7A828C) : hex(0x80868C);
    look.accent = look.text;
    look.on_accent = look.panel;
}

void color_widgets(const Look& look, ImVec4* c) {
    c[ImGuiCol_Text] = look.text;
    c[ImGuiCol_TextDisabled] = look.dim;
    c[ImGuiCol_WindowBg] = look.panel;
    c[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
    c[ImGuiCol_PopupBg] = look.panel;
    c[ImGuiCol_Border] = look.line;
    c[ImGuiCol_BorderShadow] = ImVec4(0, 0, 0, 0);
    c[ImGuiCol_FrameBg] = look.field;
    c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_FrameBgActive] = look.line;
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = look.card;
    c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
    c[ImGuiCol_ScrollbarGrab] = look.line;
    c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = look.dim;
    c[ImGuiCol_CheckMark] = look.accent;
    c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = look.accent;
    c[ImGuiCol_Button] = look.field;
    c[ImGuiCol_ButtonHovered] = c[ImGuiCol_ButtonActive] = look.line;
    c[ImGuiCol_Header] = faded(look.accent, 0.10f);
    c[ImGuiCol_HeaderHovered] = faded(look.accent, 0.12f);
    c[ImGuiCol_HeaderActive] = faded(look.accent, 0.18f);
    c[ImGuiCol_Separator] = look.line;
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = look.dim;
    c[ImGuiCol_TextSelectedBg] = faded(to_imgui(kTangentColor), 0.35f);
    c[ImGuiCol_DragDropTarget] = look.accent;
    c[ImGuiCol_NavHighlight] = faded(look.accent, 0.75f);
    c[ImGuiCol_ModalWindowDimBg] = ImVec4(0.05f, 0.06f, 0.08f, 0.35f);
    c[ImGuiCol_TableBorderLight] = c[ImGuiCol_TableBorderStrong] = look.line;
}

}  // namespace

float Look::px(float logical) const { return std::round(logical * scale); }

Look Look::smaller(float by) const {
    Look look = *this;
    look.scale *= by;
    look.shrink *= by;
    return look;
}

ImVec4 Look::readable(const glm::vec3& color) const {
    const glm::vec3 toward = is_dark(theme) ? glm::vec3(1.0f) : glm::vec3(0.0f);
    const float more = has_contrast(theme) ? 0.18f : 0.0f;
    return to_imgui(glm::mix(color, toward, (is_dark(theme) ? 0.25f : 0.22f) + more));
}
ImVec4 Look::readable(Rule rule) const { return readable(rule_color(rule)); }

ImVec4 to_imgui(const glm::vec3& color, float alpha) { return {color.r, color.g, color.b, alpha}; }
ImVec4 faded(ImVec4 color, float alpha) {
    color.w *= alpha;
    return color;
}
ImU32 packed(const ImVec4& color) { return ImGui::GetColorU32(color); }

void set_style(Look& look, Theme theme, float scale) {
    look.theme = theme;
    look.scale = scale;
    set_colors(look);

    ImGuiStyle style;
    style.WindowPadding = {16, 14};
    style.WindowBorderSize = 0;
    style.WindowRounding = 10;
    style.ChildRounding = 8;
    style.PopupRounding = 8;
    style.FrameRounding = 6;
    style.GrabRounding = 6;
    style.ScrollbarRounding = 6;
    style.ScrollbarSize = 8;
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {7, 4};
    style.CellPadding = {4, 2};
    style.IndentSpacing = 14;
    style.DisabledAlpha = 0.42f;
    style.ScaleAllSizes(scale);
    style.PopupBorderSize = 1;
    style.HoverDelayNormal = 0.45f;
    color_widgets(look, style.Colors);
    ImGui::GetStyle() = style;
}

}  // namespace normalscope

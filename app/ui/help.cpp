#include "ui/help.h"

#include "ui/kit/own_keys.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

namespace normalscope {

namespace {

struct Line {
    const char *keys, *does;  ///< keys apart by spaces; "_" stands for a space within one
};

constexpr Line kMouse[]{
    {"drag", "orbit"},
    {"drag_a_knob", "stretch the object along that axis"},
    {"click", "put the probe on the surface"},
    {"drag_the_probe", "move it (Alt + arrows, too)"},
    {"P", "pin the probe's point as a row"},
    {"Shift drag", "move the light"},
    {"right_drag", "pan (middle button, too)"},
    {"wheel", "zoom"},
};
constexpr Line kLook[]{
    {"F", "frame the object"},
    {"1 2 3", "from the front, the side, the top"},
    {"Tab", "hide or show the panel (H, too)"},
    {"D", "the derivation, beside the picture"},
    {"F5", "present: large words, no panel"},
    {"F11", "full screen"},
    {"Ctrl_+ Ctrl_−", "larger, smaller (Ctrl+0: as it was)"},
    {"F1", "this card"},
    {"Esc", "close what is open"},
};
constexpr Line kRulesKeys[]{
    {"N", "naive: M n"},
    {"I", "inverse transpose: (M⁻¹)ᵀ n"},
    {"C", "cofactor: cof(M) n"},
    {"V", "next view: single, split, overlay, flat"},
    {"G", "ghost of the object"},
    {"E", "light, error map, normals"},
    {"O", "a polygon at the probe"},
    {"T", "light or dark theme"},
};
constexpr Line kWork[]{
    {"R", "reset the transform"},           {"Ctrl Z", "undo"},
    {"Ctrl Shift Z", "redo (Ctrl+Y, too)"}, {"Ctrl O", "open a scene or a mesh"},
    {"Ctrl S", "save the scene"},           {"Ctrl Shift S", "save it by another name"},
    {"Ctrl P", "save the picture"},         {"Ctrl F", "type a formula"},
    {"Ctrl C", "copy as a command"},        {"Ctrl L", "copy a link to the scene"},
    {"Ctrl V", "open a copied link"},       {"Ctrl Shift L", "copy the equations as LaTeX"},
};

constexpr Line kLesson[]{
    {"Page_Down →", "next step"},
    {"Page_Up ←", "previous step"},
    {"Home End", "the step again; the last step"},
    {"A B C D", "answer a question (1 2 3 4, too)"},
    {"B W M", "presenting: black, white, next monitor"},
};

constexpr float kKeysWidth = 128.0f, kColumnWidth = 376.0f, kGap = 24.0f;

// Keys as caps, the last of which ends where the column does.
void key_caps(const Look& look, std::string_view keys) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = look.fonts.small->FontSize + look.px(4);
    float right = at.x + look.px(kKeysWidth);
    while (!keys.empty()) {
        const auto space = keys.rfind(' ');
        std::string key(space == std::string_view::npos ? keys : keys.substr(space + 1));
        keys = space == std::string_view::npos ? std::string_view{} : keys.substr(0, space);
        std::ranges::replace(key, '_', ' ');
        const float width = std::max(
            look.fonts.small->CalcTextSizeA(look.fonts.small->FontSize, 1e9f, 0, key.c_str()).x + look.px(12), height);
        const ImVec2 low{right - width, at.y + look.px(1)}, high{right, at.y + look.px(1) + height};
        list.AddRectFilled(low, high, packed(look.field), look.px(4));
        list.AddRect(low, high, packed(look.line), look.px(4));
        const float text = look.fonts.small->CalcTextSizeA(look.fonts.small->FontSize, 1e9f, 0, key.c_str()).x;
        list.AddText(look.fonts.small, look.fonts.small->FontSize,
                     {std::round((low.x + high.x - text) / 2), low.y + look.px(2)}, packed(look.text), key.c_str());
        right = low.x - look.px(4);
    }
}

void block(const Look& look, const char* title, std::span<const Line> lines) {
    ImGui::PushFont(look.fonts.strong);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    for (const Line& line : lines) {
        const float left = ImGui::GetCursorPosX();
        key_caps(look, with_own_keys(line.keys));
        ImGui::SetCursorPosX(left + look.px(kKeysWidth + 12));
        ImGui::TextUnformatted(with_own_keys(line.does).c_str());
    }
}

}  // namespace

void draw_help(const Look& look, const PixelRect& picture, bool& open) {
    if (!open) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    // In two columns, where the window is as wide.
    const bool beside = screen.x >= look.px(2 * kColumnWidth + 3 * kGap);
    const float width = look.px(beside ? 2 * kColumnWidth + 3 * kGap : kColumnWidth + 2 * kGap);
    // In the picture's middle where it fits there, else in the window's.
    const bool fits = static_cast<float>(picture.size.x) > width;
    const float middle =
        fits ? static_cast<float>(picture.origin.x) + static_cast<float>(picture.size.x) / 2 : screen.x / 2;
    ImGui::SetNextWindowPos({middle, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {screen.x, screen.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(kGap), look.px(18)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(12));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(8), look.px(4)));
    ImGui::Begin("##help", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushFont(look.fonts.title);
    ImGui::TextUnformatted("Mouse and keys");
    ImGui::PopFont();
    ImGui::SameLine(width - look.px(kGap + 30));
    if (icon_button(look, "##close", {.icon = Icon::Close, .about = "Close (Esc)", .side = 28})) open = false;
    ImGui::Dummy({0, look.px(4)});
    const ImVec2 top = ImGui::GetCursorPos();
    ImGui::BeginGroup();
    block(look, "In the picture", kMouse);
    ImGui::Dummy({0, look.px(8)});
    block(look, "Looking", kLook);
    ImGui::Dummy({0, look.px(8)});
    block(look, "Lessons and lectures", kLesson);
    ImGui::EndGroup();
    if (beside)
        ImGui::SetCursorPos({top.x + look.px(kColumnWidth + kGap), top.y});
    else
        ImGui::Dummy({0, look.px(8)});
    ImGui::BeginGroup();
    block(look, "Rules and views", kRulesKeys);
    ImGui::Dummy({0, look.px(8)});
    block(look, "Working", kWork);
    ImGui::EndGroup();
    const bool elsewhere =
        ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow);
    ImGui::End();
    ImGui::PopStyleVar(4);
    if (elsewhere || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) open = false;
}

}  // namespace normalscope

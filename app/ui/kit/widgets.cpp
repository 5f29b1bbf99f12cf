#include "ui/kit/widgets.h"

#include "ui/kit/number_text.h"
#include "ui/kit/own_keys.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

void show_tip(const Look& look, const char* text) {
    if (!ImGui::BeginTooltip()) return;
    ImGui::PushFont(look.fonts.small);
    ImGui::PushTextWrapPos(look.px(340));
    ImGui::TextUnformatted(with_own_keys(text).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::EndTooltip();
}

void tip(const Look& look, const char* text) {
    // Who has just clicked looks at what comes of it: the tip would cover that, so it waits for the pointer's return.
    constexpr ImGuiID kClicked = 0x7469705F;  // in the window's storage: the item
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const auto item = static_cast<int>(ImGui::GetItemID());
    const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
    if (ImGui::IsItemActive() || ImGui::IsItemDeactivated())
        storage.SetInt(kClicked, item);
    else if (!hovered && storage.GetInt(kClicked) == item)
        storage.SetInt(kClicked, 0);
    if (!*text || !hovered || !look.tips || storage.GetInt(kClicked) == item) return;
    // So does another one's that has come up where the click was.
    const ImVec2 at = ImGui::GetMousePos(), clicked = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
    if (std::abs(at.x - clicked.x) + std::abs(at.y - clicked.y) < look.px(4)) return;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled)) return;
    show_tip(look, text);
}

void begin_beside(const PixelRect& picture, const char* id, ImVec2 at, ImVec2 size, ImGuiWindowFlags flags,
                  bool over_another) {
    const auto left = static_cast<float>(picture.origin.x), right = left + static_cast<float>(picture.size.x);
    if (!over_another && (at.x + size.x <= left || at.x >= right)) flags |= ImGuiWindowFlags_NoBackground;
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse | flags);
    ImGui::PopStyleVar(2);
}

bool section(const Look& look, const char* title, bool open_at_first) {
    if (ImGui::GetCursorPosY() > look.px(8)) ImGui::Dummy({0, 0});  // but for the first
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = look.px(28);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine(from, {from.x + width, from.y}, packed(look.line));
    ImGui::SetCursorScreenPos({from.x, from.y + look.px(4)});
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float middle = low.y + height / 2;
    const auto write = [&](float left) {
        list.AddText(look.fonts.strong, look.fonts.strong->FontSize,
                     {low.x + left, middle - look.fonts.strong->FontSize / 2}, packed(look.text), title);
    };
    if (look.still) {
        ImGui::Dummy({width, height});
        write(0.0f);
        return open_at_first;
    }

    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(title);
    bool open = storage.GetBool(id, open_at_first);
    ImGui::SetNextItemAllowOverlap();
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::PushID(title);
    if (ImGui::Button("##section", {width, height})) storage.SetBool(id, open = !open);
    ImGui::PopID();
    ImGui::PopStyleColor();
    draw_icon(list, open ? Icon::Down : Icon::Right, {low.x + look.px(6), middle}, look.px(12), packed(look.dim));
    write(look.px(18));
    return open;
}

bool begin_combo(const Look& look, const char* id, const std::string& current, float width) {
    ImGui::SetNextItemWidth(width);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool open = ImGui::BeginCombo(id, shortened(current, width - look.px(38)).c_str(),
                                        ImGuiComboFlags_HeightLargest | ImGuiComboFlags_NoArrowButton);
    draw_icon(list, Icon::Down, {at.x + width - look.px(15), at.y + height / 2}, look.px(12), packed(look.dim));
    return open;
}

bool icon_button(const Look& look, const char* id, const IconButton& button) {
    ImGui::BeginDisabled(!button.enabled);
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    const bool pressed = ImGui::Button(id, {look.px(button.side), look.px(button.side)});
    ImGui::PopStyleColor();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    draw_icon(*ImGui::GetWindowDrawList(), button.icon, {(low.x + high.x) / 2, (low.y + high.y) / 2},
              look.px(button.side * 0.56f), packed(look.text));
    ImGui::EndDisabled();
    tip(look, button.about);
    return pressed;
}

bool accented_button(const Look& look, const char* label, bool accented, ImVec2 size) {
    if (!accented) return ImGui::Button(label, size);
    ImGui::PushStyleColor(ImGuiCol_Button, look.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(look.accent, 0.85f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(look.accent, 0.7f));
    ImGui::PushStyleColor(ImGuiCol_Text, look.on_accent);
    const bool pressed = ImGui::Button(label, size);
    ImGui::PopStyleColor(4);
    return pressed;
}

bool segmented(const Look& look, const char* id, int& chosen, std::span<const Segment> choices) {
    ImGui::PushID(id);
    const float height = ImGui::GetFrameHeight() + look.px(2), inset = look.px(2);
    const float width = (ImGui::CalcItemWidth() - 2 * inset) / static_cast<float>(choices.size());
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + ImGui::CalcItemWidth(), from.y + height},
                                              packed(look.field), look.px(7));
    bool changed = false;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const bool down = static_cast<std::size_t>(chosen) == i;
        ImGui::SetCursorScreenPos({std::round(from.x + inset + width * static_cast<float>(i)), from.y + inset});
        ImGui::PushStyleColor(ImGuiCol_Button, down ? look.accent : ImVec4(0, 0, 0, 0));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, down ? look.accent : look.line);
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, down ? look.accent : look.line);
        ImGui::PushStyleColor(ImGuiCol_Text, down ? look.on_accent : look.text);
        if (ImGui::Button(choices[i].label, {std::floor(width), height - 2 * inset}) && !down) {
            chosen = static_cast<int>(i);
            changed = true;
        }
        ImGui::PopStyleColor(4);
        tip(look, choices[i].about);
    }
    ImGui::SetCursorScreenPos({from.x, from.y + height - ImGui::GetStyle().ItemSpacing.y});
    ImGui::Dummy({ImGui::CalcItemWidth(), 0});
    ImGui::EndGroup();
    ImGui::PopID();
    return changed;
}

void text_right(std::string_view text, float right) {
    const float width = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
    ImGui::SetCursorPosX(std::round(right - width));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void dim_text(const Look& look, std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, look.dim);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

std::string shortened(std::string text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    while (!text.empty() && ImGui::CalcTextSize((text + "…").c_str()).x > width) {
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
        if (!text.empty()) text.pop_back();
    }
    return text + "…";
}

void matrix_in_brackets(const Look& look, const glm::dmat4& m, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float row = ImGui::GetTextLineHeight() + look.px(3), pad = look.px(6);
    const float height = 4 * row + pad, column = (width - 2 * pad) / 4, lip = look.px(5),
                weight = std::max(1.0f, look.px(1.25f));
    for (const float side : {0.0f, 1.0f}) {
        const float x = from.x + side * width, inward = side == 0.0f ? lip : -lip;
        list.PathLineTo({x + inward, from.y});
        list.PathLineTo({x, from.y});
        list.PathLineTo({x, from.y + height});
        list.PathLineTo({x + inward, from.y + height});
        list.PathStroke(packed(look.text), 0, weight);
    }
    list.AddRectFilled({from.x + pad, from.y + pad / 2},
                       {from.x + pad + 3 * column + look.px(3), from.y + pad / 2 + 3 * row}, packed(look.field),
                       look.px(5));
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            const std::string text = fixed(m[c][r]);
            const float right = from.x + pad + column * static_cast<float>(c + 1) - look.px(3);
            list.AddText({std::round(right - ImGui::CalcTextSize(text.c_str()).x),
                          std::round(from.y + pad / 2 + row * static_cast<float>(r) + look.px(1))},
                         packed(r < 3 && c < 3 ? look.text : look.dim), text.c_str());
        }
    ImGui::Dummy({width, height});
}

}  // namespace normalscope

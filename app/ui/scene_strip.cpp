#include "ui/scene_strip.h"

#include "ui/kit/widgets.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr float kLeastBesideButtons = 560.0f;  // logical pixels; a narrower strip holds the words alone

// The largest font in which the words stand in two lines; the smallest may take more.
const ImFont* fitting(const Look& look, const std::string& words, ImVec2 size) {
    for (const ImFont* font : {look.fonts.title, look.fonts.strong, look.fonts.body})
        if (font->CalcTextSizeA(font->FontSize, 1e9f, size.x, words.c_str()).y <=
            std::min(2.1f * font->FontSize, size.y))
            return font;
    return look.fonts.small;
}

// In the middle of the height; cut off below where there is no room at all, with the whole of it where one points.
void sentence(const Look& look, const std::string& words, ImVec2 low, ImVec2 size) {
    const ImFont* font = fitting(look, words, size);
    const float height = font->CalcTextSizeA(font->FontSize, 1e9f, size.x, words.c_str()).y;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, {low.x + size.x + 1, low.y + size.y}, true);
    list.AddText(font, font->FontSize, {low.x, low.y + std::max(0.0f, std::round((size.y - height) / 2))},
                 packed(look.text), words.c_str(), nullptr, size.x);
    list.PopClipRect();
    ImGui::SetCursorScreenPos(low);
    ImGui::Dummy(size);
    if (height > size.y) tip(look, words.c_str());
}

}  // namespace

float scene_strip_height(const Look& look, float width) {
    const bool buttons = width >= look.px(kLeastBesideButtons);
    // As high as the longest of the built-in sentences is in small words, so that it stays as it is while one drags. There
    // may be no fonts yet.
    constexpr float kLongest = 160.0f;  // letters, and what is left over at the ends of lines
    constexpr float kLetter = 6.7f, kLine = 18.0f;
    const float room = width - look.px(buttons ? 14 * 2 + 38 + 150 : 14 * 2 + 38),
                lines = std::ceil(look.px(kLongest * kLetter) / std::max(room, look.px(kLetter)));
    return std::max(look.px(buttons ? 56.0f : 78.0f), look.px(lines * kLine + 8));
}

StripPress draw_scene_strip(const Look& look, const SceneStrip& strip, const PixelRect& picture) {
    StripPress press = StripPress::None;
    const ImVec2 low(static_cast<float>(picture.origin.x), 0.0f),
        size(static_cast<float>(picture.size.x), static_cast<float>(picture.origin.y));
    begin_beside(picture, "##strip", low, size);
    ImGui::GetWindowDrawList()->AddLine({low.x, low.y + size.y - 1}, {low.x + size.x, low.y + size.y - 1},
                                        packed(look.line));
    const float margin = look.px(14), side = look.px(30);
    float left = low.x + margin, right = low.x + size.x - margin;
    if (strip.plays) {
        ImGui::SetCursorScreenPos({left, low.y + (size.y - side) / 2});
        if (icon_button(
                look, "##play",
                {.icon = strip.playing ? Icon::Pause : Icon::Play,
                 .about = strip.playing ? "Stop here." : "See it happen: from the object as it is to all of M."}))
            press = StripPress::Play;
        left += side + look.px(8);
    }
    if (size.x >= look.px(kLeastBesideButtons)) {
        const float pad = look.px(12), height = look.px(30);
        const auto button = [&](const char* label, const char* about) {
            const float width = ImGui::CalcTextSize(label).x + 2 * pad;
            right -= width;
            ImGui::SetCursorScreenPos({right, low.y + (size.y - height) / 2});
            const bool pressed = ImGui::Button(label, {width, height});
            tip(look, about);
            right -= look.px(6);
            return pressed;
        };
        if (button("Try it", "Exercises: where does this normal go?")) press = StripPress::TryIt;
        if (button("Why?", "The derivation, at the line that is at stake. (D: all of it)")) press = StripPress::Why;
        right -= look.px(8);
    }
    sentence(look, strip.sentence, {left, low.y + look.px(4)}, {std::max(right - left, 1.0f), size.y - look.px(8)});
    ImGui::End();
    return press;
}

}  // namespace normalscope

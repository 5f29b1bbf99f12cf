#include "ui/kit/color_key.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace normalscope {

namespace {

const ImFont* words(const Look& look) { return look.fonts.caption ? look.fonts.body : look.fonts.small; }

float width_of(const ImFont* font, std::string_view text) {
    return font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.data(), text.data() + text.size()).x;
}

void write(const ImFont* font, ImVec2 at, const ImVec4& color, std::string_view text) {
    ImGui::GetBackgroundDrawList()->AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)}, packed(color),
                                            text.data(), text.data() + text.size());
}

void draw_normals(const Look& look, const ImVec4& ink, ImVec2 low, ImVec2 size) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImFont* font = words(look);
    const float width = (size.x - look.px(36)) / 3, top = low.y + look.px(26);
    for (int k = 0; k < 3; ++k) {
        const ImVec2 from{low.x + look.px(16) + static_cast<float>(k) * width, top},
            to{from.x + width - look.px(8), top + look.px(12)};
        glm::vec3 least(0.5f), most(0.5f);
        least[k] = 0.0f;
        most[k] = 1.0f;
        const ImU32 a = packed(to_imgui(least)), b = packed(to_imgui(most));
        list.AddRectFilledMultiColor(from, to, a, b, b, a);
        list.AddRect(from, to, packed(faded(ink, 0.35f)));
        const char axis[] = {"xyz"[k], '\0'};
        const std::array<std::string, 3> ends{"−1", axis, "1"};
        for (std::size_t i = 0; i < ends.size(); ++i)
            write(font,
                  {from.x + (to.x - from.x - width_of(font, ends[i])) * static_cast<float>(i) / 2, to.y + look.px(4)},
                  ink, ends[i]);
    }
}

void draw_errors(const Look& look, const ImVec4& ink, ImVec2 low, ImVec2 size) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImFont* font = words(look);
    const ImVec2 bar{low.x + look.px(16), low.y + look.px(26)}, end{low.x + size.x - look.px(20), bar.y + look.px(12)};
    constexpr int kSteps = 45;
    const auto x = [&](float degrees) { return bar.x + (end.x - bar.x) * degrees / 90.0f; };
    for (int i = 0; i < kSteps; ++i) {
        const float from = 90.0f * static_cast<float>(i) / kSteps, to = 90.0f * static_cast<float>(i + 1) / kSteps;
        const ImU32 a = packed(to_imgui(error_color(from))), b = packed(to_imgui(error_color(to)));
        list.AddRectFilledMultiColor({x(from), bar.y}, {x(to), end.y}, a, b, b, a);
    }
    list.AddRect(bar, end, packed(faded(ink, 0.35f)));
    for (int degrees = 0; degrees <= 90; degrees += 15) {
        const float at = std::round(x(static_cast<float>(degrees)));
        const bool named = degrees % 30 == 0;
        list.AddLine({at, end.y}, {at, end.y + look.px(named ? 4 : 2)}, packed(ink));
        if (!named) continue;
        const std::string number = std::to_string(degrees);
        write(font, {at - width_of(font, number) / 2, end.y + look.px(4)}, ink, number + "°");
    }
}

}  // namespace

void draw_card(const Look& look, const ThemeColors& colors, ImVec2 low, ImVec2 high) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(low, high, packed(faded(to_imgui(colors.text_shadow), 0.78f)), look.px(8));
    list.AddRect(low, high, packed(faded(to_imgui(colors.grid), 0.25f)), look.px(8));
}

ImVec2 color_key_size(const Look& look, float room, const std::string& title) {
    const float least = std::max(look.px(120), width_of(words(look), title) + look.px(16 + 20));
    return {room < least ? 0.0f : std::min(look.px(284), room), look.px(64)};
}

void draw_color_key(const Look& look, const Frame& frame, ImVec2 low, ImVec2 size) {
    const ThemeColors colors = theme_colors(frame.theme);
    const ImVec4 ink = to_imgui(colors.text);
    draw_card(look, colors, low, {low.x + size.x, low.y + size.y});
    write(words(look), {low.x + look.px(16), low.y + look.px(5)}, ink, frame.color_key->text);
    if (frame.color_key->of == SurfaceColor::Error)
        draw_errors(look, ink, low, size);
    else
        draw_normals(look, ink, low, size);
}

}  // namespace normalscope

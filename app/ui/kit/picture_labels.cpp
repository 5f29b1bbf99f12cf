#include "ui/kit/picture_labels.h"

#include "ui/kit/icons.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

namespace {

constexpr float kLegendInLecture = 0.42f;  // of the picture, where words are large: it is not to hide what it explains

ImVec2 extent(const ImFont* font, std::string_view text) {
    return font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.data(), text.data() + text.size());
}

/// Writes into one pane, over a frame's picture.
class Writer {
public:
    Writer(const Look& look, const Frame& frame)
        : look_{look},
          words_{look.fonts.caption ? look.fonts.body : look.fonts.small},
          colors_{theme_colors(frame.theme)},
          list_{*ImGui::GetBackgroundDrawList()} {}

    void plain(const ImFont* font, ImVec2 at, const ImVec4& color, std::string_view text) const {
        list_.AddText(font, font->FontSize, {std::round(at.x), std::round(at.y)}, packed(color), text.data(),
                      text.data() + text.size());
    }

    // A soft edge in the ground's colour keeps the words readable on whatever lies behind.
    void haloed(const ImFont* font, ImVec2 at, const glm::vec3& color, std::string_view text) const {
        const ImVec4 halo = to_imgui(colors_.text_shadow);
        for (const float radius : {2.0f, 1.0f})
            for (int i = 0; i < 8; ++i) {
                const float angle = static_cast<float>(i) * 0.785398f, r = radius * look_.scale;
                const ImVec2 to{at.x + r * std::cos(angle), at.y + r * std::sin(angle)};
                list_.AddText(font, font->FontSize, to, packed(faded(halo, radius > 1.5f ? 0.22f : 0.55f)), text.data(),
                              text.data() + text.size());
            }
        plain(font, at, to_imgui(color), text);
    }

    // As large as the narrowest pane allows, so that all are alike; a very narrow one keeps what follows the last wide
    // gap, the formula.
    struct TitleStyle {
        const ImFont* font;
        bool whole;
        float pad, top;
    };
    TitleStyle title_style(const Frame& frame) const {
        const TitleStyle large{look_.fonts.title, true, look_.px(18), look_.px(14)},
            narrow{words_, false, look_.px(12), look_.px(8)};
        for (const TitleStyle& style : {large, TitleStyle{look_.fonts.strong, true, narrow.pad, narrow.top},
                                        TitleStyle{words_, true, narrow.pad, narrow.top},
                                        TitleStyle{look_.fonts.strong, false, narrow.pad, narrow.top}}) {
            // A large one would stand before the object's top where there is little room.
            bool fits = style.font != look_.fonts.title || frame.rect.size.y >= static_cast<int>(look_.px(400));
            for (const Pane& pane : frame.panes)
                for (const Label& label : pane.labels)
                    if (label.role == Label::Role::Title)
                        fits &= extent(style.font, title_text(label, style)).x + 2 * style.pad + look_.px(8) <=
                                static_cast<float>(pane.rect.size.x);
            if (fits) return style;
        }
        return narrow;
    }
    static std::string_view title_text(const Label& label, const TitleStyle& style) {
        const auto gap = label.text.rfind("   ");
        return style.whole || gap == std::string::npos ? std::string_view(label.text)
                                                       : std::string_view(label.text).substr(gap + 3);
    }
    void title(const Pane& pane, const Label& label, const TitleStyle& style) const {
        const std::string_view text = title_text(label, style);
        const ImVec2 size = extent(style.font, text);
        const float middle = static_cast<float>(pane.rect.origin.x) + static_cast<float>(pane.rect.size.x) / 2;
        const float top = static_cast<float>(pane.rect.origin.y) + style.top;
        const ImVec2 low{std::round(middle - size.x / 2 - style.pad), top},
            high{std::round(middle + size.x / 2 + style.pad), top + size.y + look_.px(10)};
        if (high.x - low.x > static_cast<float>(pane.rect.size.x)) return;
        list_.AddRectFilled(low, high, packed(to_imgui(label.color)), (high.y - low.y) / 2);
        plain(style.font, {middle - size.x / 2, low.y + look_.px(5)}, {1, 1, 1, 1}, text);
    }

    void label(const Pane& pane, const Label& label) const {
        const glm::vec2 inside = label.pixel - glm::vec2(pane.rect.origin), size_of_pane(pane.rect.size);
        if (inside.x < 0.0f || inside.y < 0.0f || inside.x > size_of_pane.x || inside.y > size_of_pane.y) return;
        const bool small = label.role == Label::Role::Note || label.role == Label::Role::Level;
        const bool boxed = label.role == Label::Role::Side || label.role == Label::Role::Level;
        const ImFont* font = small ? words_ : look_.fonts.strong;
        const float room = size_of_pane.x - look_.px(8);
        if (extent(font, label.text).x > room) font = words_;
        const ImVec2 size = extent(font, label.text);
        if (size.x > room) return;  // rather none than half a word
        ImVec2 at{label.pixel.x - size.x / 2, label.pixel.y - size.y / 2};
        if (label.role == Label::Role::Note) at = {label.pixel.x + look_.px(10), label.pixel.y + look_.px(4)};
        const ImVec2 low(static_cast<float>(pane.rect.origin.x) + look_.px(4),
                         static_cast<float>(pane.rect.origin.y) + look_.px(4));
        const ImVec2 high(low.x + static_cast<float>(pane.rect.size.x) - look_.px(8) - size.x,
                          low.y + static_cast<float>(pane.rect.size.y) - look_.px(8) - size.y);
        at = {std::clamp(at.x, low.x, std::max(low.x, high.x)), std::clamp(at.y, low.y, std::max(low.y, high.y))};
        if (boxed) {
            const float pad = look_.px(small ? 4 : 7), above = look_.px(small ? 0 : 2);
            list_.AddRectFilled({std::round(at.x - pad), std::round(at.y - above)},
                                {std::round(at.x + size.x + pad), std::round(at.y + size.y + above)},
                                packed(faded(to_imgui(colors_.text_shadow), 0.8f)), look_.px(4));
            return plain(font, at, to_imgui(label.color), label.text);
        }
        // In words the palette's deeper colours drown in the dark, and its paler ones in the light.
        haloed(font, at, glm::mix(label.color, colors_.text, 0.3f), label.text);
    }

    void card(ImVec2 low, ImVec2 high) const {
        list_.AddRectFilled(low, high, packed(faded(to_imgui(colors_.text_shadow), 0.78f)), look_.px(8));
        list_.AddRect(low, high, packed(faded(to_imgui(colors_.grid), 0.25f)), look_.px(8));
    }

    // Where the names have no room, formulas alone; where these have none, nothing.
    std::vector<LegendEntry> legend_within(ImVec2 room, std::vector<LegendEntry> entries) const {
        const auto fits = [&] { return legend_size(entries).x <= room.x && legend_size(entries).y <= room.y; };
        if (!fits())
            for (LegendEntry& entry : entries)
                if (const auto gap = entry.text.find("  "); gap != std::string::npos) entry.text.erase(0, gap + 2);
        if (!fits()) entries.clear();
        return entries;
    }
    ImVec2 legend_size(const std::vector<LegendEntry>& entries) const {
        float width = 0.0f;
        for (const LegendEntry& entry : entries) width = std::max(width, extent(words_, entry.text).x);
        return {width + look_.px(12 + 30 + 9 + 14), static_cast<float>(entries.size()) * row() + look_.px(14)};
    }

    void legend(ImVec2 low, const std::vector<LegendEntry>& entries) const {
        const ImVec2 size = legend_size(entries);
        card(low, {low.x + size.x, low.y + size.y});
        float y = low.y + look_.px(7) + row() / 2;
        for (const LegendEntry& entry : entries) {
            draw_arrow(list_, entry.look, {low.x + look_.px(12), y}, {low.x + look_.px(42), y}, look_.px(3),
                       packed(to_imgui(entry.color)));
            plain(words_, {low.x + look_.px(51), y - words_->FontSize / 2}, to_imgui(colors_.text), entry.text);
            y += row();
        }
    }

    // As wide as there is room, if there is enough for its title.
    ImVec2 key_size(float room, const std::string& title) const {
        const float least = std::max(look_.px(120), extent(words_, title).x + look_.px(16 + 20));
        return {room < least ? 0.0f : std::min(look_.px(284), room), look_.px(64)};
    }

    void normals_key(ImVec2 low, ImVec2 size, const std::string& text) const {
        card(low, {low.x + size.x, low.y + size.y});
        const ImFont* font = words_;
        plain(font, {low.x + look_.px(16), low.y + look_.px(5)}, to_imgui(colors_.text), text);
        const float width = (size.x - look_.px(36)) / 3, top = low.y + look_.px(26);
        for (int k = 0; k < 3; ++k) {
            const ImVec2 from{low.x + look_.px(16) + static_cast<float>(k) * width, top},
                to{from.x + width - look_.px(8), top + look_.px(12)};
            glm::vec3 least(0.5f), most(0.5f);
            least[k] = 0.0f;
            most[k] = 1.0f;
            const ImU32 a = packed(to_imgui(least)), b = packed(to_imgui(most));
            list_.AddRectFilledMultiColor(from, to, a, b, b, a);
            list_.AddRect(from, to, packed(faded(to_imgui(colors_.text), 0.35f)));
            const char axis[] = {"xyz"[k], '\0'};
            const std::array<std::string, 3> words{"−1", axis, "1"};
            for (std::size_t i = 0; i < words.size(); ++i)
                plain(font,
                      {from.x + (to.x - from.x - extent(font, words[i]).x) * static_cast<float>(i) / 2,
                       to.y + look_.px(4)},
                      to_imgui(colors_.text), words[i]);
        }
    }

    void error_key(ImVec2 low, ImVec2 size, const std::string& title) const {
        card(low, {low.x + size.x, low.y + size.y});
        const ImFont* font = words_;
        plain(font, {low.x + look_.px(16), low.y + look_.px(5)}, to_imgui(colors_.text), title);
        const ImVec2 bar{low.x + look_.px(16), low.y + look_.px(26)},
            end{low.x + size.x - look_.px(20), bar.y + look_.px(12)};
        constexpr int kSteps = 45;
        const auto x = [&](float degrees) { return bar.x + (end.x - bar.x) * degrees / 90.0f; };
        for (int i = 0; i < kSteps; ++i) {
            const float from = 90.0f * static_cast<float>(i) / kSteps, to = 90.0f * static_cast<float>(i + 1) / kSteps;
            const ImU32 a = packed(to_imgui(error_color(from))), b = packed(to_imgui(error_color(to)));
            list_.AddRectFilledMultiColor({x(from), bar.y}, {x(to), end.y}, a, b, b, a);
        }
        list_.AddRect(bar, end, packed(faded(to_imgui(colors_.text), 0.35f)));
        for (int degrees = 0; degrees <= 90; degrees += 15) {
            const float at = std::round(x(static_cast<float>(degrees)));
            const bool named = degrees % 30 == 0;
            list_.AddLine({at, end.y}, {at, end.y + look_.px(named ? 4 : 2)}, packed(to_imgui(colors_.text)));
            if (!named) continue;
            const std::string text = std::to_string(degrees) + "°";
            plain(font, {at - extent(font, std::to_string(degrees)).x / 2, end.y + look_.px(4)}, to_imgui(colors_.text),
                  text);
        }
    }

private:
    float row() const { return words_->FontSize + look_.px(4); }

    const Look& look_;
    const ImFont* words_;  ///< of the legend and of notes: larger in a lecture
    ThemeColors colors_;
    ImDrawList& list_;
};

}  // namespace

void draw_words(const Look& look, const Frame& frame) {
    const Writer writer(look, frame);
    const auto titles = writer.title_style(frame);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const Pane& pane : frame.panes) {
        const ImVec2 low(static_cast<float>(pane.rect.origin.x), static_cast<float>(pane.rect.origin.y));
        list.PushClipRect(low,
                          {low.x + static_cast<float>(pane.rect.size.x), low.y + static_cast<float>(pane.rect.size.y)});
        for (const Label& label : pane.labels) {
            if (label.role == Label::Role::Title)
                writer.title(pane, label, titles);
            else
                writer.label(pane, label);
        }
        list.PopClipRect();
    }

    const float margin = look.px(14);
    const float left = static_cast<float>(frame.rect.origin.x) + margin,
                right = static_cast<float>(frame.rect.origin.x + frame.rect.size.x) - margin;
    float bottom = static_cast<float>(frame.rect.origin.y + frame.rect.size.y) - margin;
    const float room = right - left;
    const auto key = frame.color_key ? writer.key_size(room, frame.color_key->text) : ImVec2(0, 0);
    float beside = left;
    const auto legend = writer.legend_within({look.fonts.caption ? kLegendInLecture * room : room,
                                              bottom - static_cast<float>(frame.rect.origin.y) - margin},
                                             frame.legend);
    if (!legend.empty()) {
        const ImVec2 size = writer.legend_size(legend);
        writer.legend({left, bottom - size.y}, legend);
        beside = left + size.x + margin;
        if (right - key.x < beside) bottom -= size.y + look.px(8);  // no room beside it: above
    }
    if (key.x == 0.0f) return;
    const ImVec2 low{right - key.x < beside ? left : right - key.x, bottom - key.y};
    if (frame.color_key->of == SurfaceColor::Error)
        writer.error_key(low, key, frame.color_key->text);
    else
        writer.normals_key(low, key, frame.color_key->text);
}

float titles_height(const Look& look, const Frame& frame) {
    for (const Pane& pane : frame.panes)
        for (const Label& label : pane.labels)
            if (label.role == Label::Role::Title) return look.px(14 + 10 + 8) + look.fonts.title->FontSize;
    return 0.0f;
}

}  // namespace normalscope

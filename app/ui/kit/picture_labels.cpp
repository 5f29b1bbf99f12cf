#include "ui/kit/picture_labels.h"

#include "core/frame/label_room.h"
#include "ui/kit/color_key.h"
#include "ui/kit/icons.h"

#include <imgui_internal.h>  // ImTextCharFromUtf8
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

// Of the picture's width, where words are large: a legend that would be wider goes without its names.
constexpr float kLegendInLecture = 0.42f;

ImVec2 extent(const ImFont* font, std::string_view text) {
    return font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.data(), text.data() + text.size());
}

struct Box {
    ImVec2 low, high;
};
bool meet(const Box& a, const Box& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool has_letters(const ImFont* font, const std::string& text) {
    for (const char* at = text.data(); at < text.data() + text.size();) {
        unsigned letter = 0;
        at += ImTextCharFromUtf8(&letter, at, text.data() + text.size());
        if (!font->FindGlyphNoFallback(static_cast<ImWchar>(letter))) return false;
    }
    return true;
}

/// Writes into one pane, over a frame's picture.
class Writer {
public:
    Writer(const Look& look, const Frame& frame)
        : look_{look},
          words_{look.fonts.caption ? look.fonts.body : look.fonts.small},
          colors_{theme_colors(frame.theme)},
          list_{*ImGui::GetBackgroundDrawList()} {}

    const ImFont* words() const { return words_; }

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
    /// A label as it is set; nothing where there is no room for it.
    struct SetLabel {
        const ImFont* font;
        std::string_view text;
        ImVec2 at;
        Box box;  ///< what it covers, in a box of its own or without one
    };
    std::optional<SetLabel> set(const Pane& pane, const Label& label, const TitleStyle& titles) const {
        return label.role == Label::Role::Title ? set_title(pane, label, titles) : set_label(pane, label);
    }
    void draw(const Label& label, const SetLabel& set) const {
        const auto& [font, text, at, box] = set;
        if (label.role == Label::Role::Title) {
            list_.AddRectFilled(box.low, box.high, packed(to_imgui(label.color)), (box.high.y - box.low.y) / 2);
            return plain(font, at, {1, 1, 1, 1}, text);
        }
        if (is_boxed(label)) {
            list_.AddRectFilled(box.low, box.high, packed(faded(to_imgui(colors_.text_shadow), 0.8f)), look_.px(4));
            return plain(font, at, to_imgui(label.color), text);
        }
        // In words the palette's deeper colours drown in the dark, and its paler ones in the light.
        haloed(font, at, glm::mix(label.color, colors_.text, 0.3f), text);
    }

    // Where the names have no room, formulas alone; where these have none, nothing.
    std::vector<LegendEntry> legend_within(ImVec2 room, std::vector<LegendEntry> entries, const ImFont* font) const {
        const float narrow = look_.fonts.caption ? kLegendInLecture * room.x : room.x;
        if (legend_size(entries, font).x > narrow)
            for (LegendEntry& entry : entries)
                if (const auto gap = entry.text.find("  "); gap != std::string::npos) entry.text.erase(0, gap + 2);
        if (const ImVec2 size = legend_size(entries, font); size.x > room.x || size.y > room.y) entries.clear();
        return entries;
    }
    ImVec2 legend_size(const std::vector<LegendEntry>& entries, const ImFont* font) const {
        float width = 0.0f;
        for (const LegendEntry& entry : entries) width = std::max(width, extent(font, entry.text).x);
        return {width + look_.px(12 + 30 + 9 + 14), static_cast<float>(entries.size()) * row(font) + look_.px(14)};
    }

    void legend(ImVec2 low, const std::vector<LegendEntry>& entries, const ImFont* font) const {
        const ImVec2 size = legend_size(entries, font);
        draw_card(look_, colors_, low, {low.x + size.x, low.y + size.y});
        float y = low.y + look_.px(7) + row(font) / 2;
        for (const LegendEntry& entry : entries) {
            draw_arrow(list_, entry.look, {low.x + look_.px(12), y}, {low.x + look_.px(42), y}, look_.px(3),
                       packed(to_imgui(entry.color)));
            plain(font, {low.x + look_.px(51), y - font->FontSize / 2}, to_imgui(colors_.text), entry.text);
            y += row(font);
        }
    }

private:
    static bool is_boxed(const Label& label) {
        return label.role == Label::Role::Side || label.role == Label::Role::Level;
    }
    std::optional<SetLabel> set_title(const Pane& pane, const Label& label, const TitleStyle& style) const {
        const std::string_view text = title_text(label, style);
        const ImVec2 size = extent(style.font, text);
        const float middle = static_cast<float>(pane.rect.origin.x) + static_cast<float>(pane.rect.size.x) / 2;
        const float top = static_cast<float>(pane.rect.origin.y) + style.top;
        const Box box{{std::round(middle - size.x / 2 - style.pad), top},
                      {std::round(middle + size.x / 2 + style.pad), top + size.y + look_.px(10)}};
        if (box.high.x - box.low.x > static_cast<float>(pane.rect.size.x)) return std::nullopt;
        return SetLabel{style.font, text, {middle - size.x / 2, top + look_.px(5)}, box};
    }
    // The faces that stand out have few letters: what one of them lacks is set in the face of all other words.
    const ImFont* font_for(const Label& label) const {
        const bool small = label.role == Label::Role::Note || label.role == Label::Role::Level;
        const ImFont* font = small ? words_ : look_.fonts.strong;
        return has_letters(font, label.text) ? font : words_;
    }
    std::optional<SetLabel> set_label(const Pane& pane, const Label& label) const {
        const glm::vec2 inside = label.pixel - glm::vec2(pane.rect.origin), size_of_pane(pane.rect.size);
        if (inside.x < 0.0f || inside.y < 0.0f || inside.x > size_of_pane.x || inside.y > size_of_pane.y)
            return std::nullopt;
        const bool small = label.role == Label::Role::Note || label.role == Label::Role::Level;
        const ImFont* font = font_for(label);
        const float room = size_of_pane.x - look_.px(8);
        if (extent(font, label.text).x > room) font = words_;
        const ImVec2 size = extent(font, label.text);
        if (size.x > room) return std::nullopt;  // rather none than half a word
        ImVec2 at{label.pixel.x - size.x / 2, label.pixel.y - size.y / 2};
        if (label.role == Label::Role::Note) at = {label.pixel.x + look_.px(10), label.pixel.y + look_.px(4)};
        const ImVec2 low(static_cast<float>(pane.rect.origin.x) + look_.px(4),
                         static_cast<float>(pane.rect.origin.y) + look_.px(4));
        const ImVec2 high(low.x + static_cast<float>(pane.rect.size.x) - look_.px(8) - size.x,
                          low.y + static_cast<float>(pane.rect.size.y) - look_.px(8) - size.y);
        at = {std::clamp(at.x, low.x, std::max(low.x, high.x)), std::clamp(at.y, low.y, std::max(low.y, high.y))};
        const float pad = is_boxed(label) ? look_.px(small ? 4 : 7) : 0.0f,
                    above = is_boxed(label) && !small ? look_.px(2) : 0.0f;
        return SetLabel{font,
                        label.text,
                        at,
                        {{std::round(at.x - pad), std::round(at.y - above)},
                         {std::round(at.x + size.x + pad), std::round(at.y + size.y + above)}}};
    }
    float row(const ImFont* font) const { return font->FontSize + look_.px(4); }

    const Look& look_;
    const ImFont* words_;  ///< of the legend and of notes: larger in a lecture
    ThemeColors colors_;
    ImDrawList& list_;
};

std::vector<Box> label_boxes(const Frame& frame, const Writer& writer) {
    std::vector<Box> boxes;
    const auto titles = writer.title_style(frame);
    for (const Pane& pane : frame.panes)
        for (const Label& label : pane.labels)
            if (const auto set = writer.set(pane, label, titles)) boxes.push_back(set->box);
    return boxes;
}

/// What a legend hides: words, lines and arrows, and parts of the objects.
struct Hidden {
    int words = 0, lines = 0;
    double objects = 0.0;  ///< 1: it lies before one as a whole

    // A word outweighs any lines, and a line any objects.
    double cost() const { return 1e6 * words + 1000.0 * lines + 100.0 * objects; }
    bool much() const { return words > 0 || objects >= 0.125; }
};
Hidden hidden_by(const Box& box, const Frame& frame, const std::vector<Box>& words) {
    Hidden hidden;
    for (const Box& word : words) hidden.words += meet(box, word) ? 1 : 0;
    for (const Pane& pane : frame.panes) {
        const glm::dvec2 origin(pane.rect.origin), low = glm::dvec2(box.low.x, box.low.y) - origin,
                                                   high = glm::dvec2(box.high.x, box.high.y) - origin;
        hidden.objects += share_within(pane.outline, low, high);
        for (const Stroke& stroke : pane.strokes) {
            const auto line = in_pixels(pane.view, stroke);
            if (line && line->length_in(0.5 * (low + high), 0.5 * (high - low)) > 0.0) ++hidden.lines;
        }
    }
    return hidden;
}

struct Legend {
    std::vector<LegendEntry> entries;
    const ImFont* font = nullptr;
    Box box{};
};
/// Where the legend stands, and the key of what the surface's colours mean.
struct Cards {
    Legend legend;
    std::optional<Box> key{};
};

// In a lecture, or where it is asked for, in the corner of the picture where it hides the least: the lower left one, unless
// another is better. Also what it hides there.
std::pair<Box, Hidden> legend_box(const Look& look, const Frame& frame, const Writer& writer, const Box& room,
                                  ImVec2 size) {
    constexpr double kElsewhere = 5.0;
    const Box usual{{room.low.x, room.high.y - size.y}, {room.low.x + size.x, room.high.y}};
    if (!look.fonts.caption && frame.legend_corner == Frame::LegendCorner::LowerLeft) return {usual, {}};
    const std::vector<Box> words = label_boxes(frame, writer);
    Box best = usual;
    double least = std::numeric_limits<double>::infinity();
    Hidden hidden;
    for (int corner = 0; corner < 4; ++corner) {
        const ImVec2 low{corner % 2 == 0 ? room.low.x : room.high.x - size.x,
                         corner < 2 ? room.high.y - size.y : room.low.y};
        const Box box{low, {low.x + size.x, low.y + size.y}};
        const Hidden here = hidden_by(box, frame, words);
        if (const double cost = kElsewhere * corner + here.cost(); cost < least)
            least = cost, best = box, hidden = here;
    }
    return {best, hidden};
}

// In a lecture, where large words would hide another word or a good part of the object, in small ones; where these would, too,
// none if the arrows at the probe have labels of their own.
Legend legend_of(const Look& look, const Frame& frame, const Writer& writer, const Box& room) {
    Legend legend;
    for (const ImFont* font : {writer.words(), static_cast<const ImFont*>(look.fonts.small)}) {
        legend = {writer.legend_within({room.high.x - room.low.x, room.high.y - room.low.y}, frame.legend, font), font};
        const auto [box, hidden] = legend_box(look, frame, writer, room, writer.legend_size(legend.entries, font));
        legend.box = box;
        if (!look.fonts.caption || !hidden.much()) return legend;
    }
    if (frame.probe && frame.probe->object.has_normal()) legend.entries.clear();
    return legend;
}

Cards cards_of(const Look& look, const Frame& frame, const Writer& writer) {
    const float margin = look.px(14);
    const glm::vec2 origin(frame.rect.origin), size(frame.rect.size);
    Box room{{origin.x + margin, origin.y + margin}, {origin.x + size.x - margin, origin.y + size.y - margin}};
    const float width = room.high.x - room.low.x;
    Cards cards{legend_of(look, frame, writer, room)};
    const ImVec2 key = frame.color_key ? color_key_size(look, width, frame.color_key->text) : ImVec2(0, 0);
    float beside = room.low.x;
    if (const Box& legend = cards.legend.box;
        !cards.legend.entries.empty() && legend.high.y == room.high.y && legend.low.x == room.low.x) {
        beside = legend.high.x + margin;
        if (room.high.x - key.x < beside) room.high.y = legend.low.y - look.px(8);  // no room beside it: above
    }
    if (key.x == 0.0f) return cards;
    const ImVec2 low{room.high.x - key.x < beside ? room.low.x : room.high.x - key.x, room.high.y - key.y};
    cards.key = Box{low, {low.x + key.x, low.y + key.y}};
    return cards;
}

}  // namespace

void draw_words(const Look& look, const Frame& frame) {
    const Writer writer(look, frame);
    const auto titles = writer.title_style(frame);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const Pane& pane : frame.panes) {
        const ImVec2 low(static_cast<float>(pane.rect.origin.x), static_cast<float>(pane.rect.origin.y));
        list.PushClipRect(low,
                          {low.x + static_cast<float>(pane.rect.size.x), low.y + static_cast<float>(pane.rect.size.y)});
        for (const Label& label : pane.labels)
            if (const auto set = writer.set(pane, label, titles)) writer.draw(label, *set);
        list.PopClipRect();
    }
    const Cards cards = cards_of(look, frame, writer);
    if (const Legend& legend = cards.legend; !legend.entries.empty())
        writer.legend(legend.box.low, legend.entries, legend.font);
    if (!cards.key) return;
    const ImVec2 low = cards.key->low;
    draw_color_key(look, frame, low, {cards.key->high.x - low.x, cards.key->high.y - low.y});
}

std::vector<PixelRect> word_boxes(const Look& look, const Frame& frame) {
    const Writer writer(look, frame);
    std::vector<Box> boxes = label_boxes(frame, writer);
    const Cards cards = cards_of(look, frame, writer);
    if (!cards.legend.entries.empty()) boxes.push_back(cards.legend.box);
    if (cards.key) boxes.push_back(*cards.key);
    std::vector<PixelRect> rects;
    for (const auto& [low, high] : boxes)
        rects.push_back({glm::ivec2(glm::floor(glm::vec2(low.x, low.y))),
                         glm::ivec2(glm::ceil(glm::vec2(high.x - low.x, high.y - low.y)))});
    return rects;
}

float titles_height(const Look& look, const Frame& frame) {
    for (const Pane& pane : frame.panes)
        for (const Label& label : pane.labels)
            if (label.role == Label::Role::Title) return look.px(14 + 10 + 8) + look.fonts.title->FontSize;
    return 0.0f;
}

}  // namespace normalscope

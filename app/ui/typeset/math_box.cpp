#include "ui/typeset/math_box.h"

#include "core/scene/palette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

namespace {

constexpr float kEm = 20.0f;            // of the letters, in logical pixels
constexpr float kLetterAscent = 0.76f;  // in ems: the height of M, or a little more
constexpr float kLetterDescent = 0.20f;

float extent(const MathStyle& style, const ImFont* font, std::string_view text) {
    return std::round(
        font->CalcTextSizeA(font->FontSize * style.shrink, 1e9f, 0, text.data(), text.data() + text.size()).x);
}

void parenthesis(MathBox& box, float x, bool left, float ascent, float descent, float wide, float weight, Ink ink) {
    const float tip = left ? x + wide : x, belly = left ? x - wide / 3 : x + wide + wide / 3;
    const float height = ascent + descent;
    box.strokes.push_back({{ImVec2(tip, -ascent), ImVec2(belly, -ascent + 0.3f * height),
                            ImVec2(belly, descent - 0.3f * height), ImVec2(tip, descent)},
                           true,
                           weight,
                           ink});
}

}  // namespace

Ink ink_of(Meaning meaning) {
    switch (meaning) {
        case Meaning::Plain: return Ink::Plain;
        case Meaning::Object: return Ink::Dim;
        case Meaning::Tangent: return Ink::Tangent;
        case Meaning::Naive: return Ink::Naive;
        case Meaning::InverseTranspose: return Ink::InverseTranspose;
        case Meaning::Cofactor: return Ink::Cofactor;
    }
    return Ink::Plain;
}

ImVec4 color_of(const Look& look, Ink ink) {
    switch (ink) {
        case Ink::Plain: return look.text;
        case Ink::Dim: return look.dim;
        case Ink::Faint: return faded(look.dim, 0.6f);
        case Ink::Tangent: return look.readable(kTangentColor);
        case Ink::Naive: return look.readable(kNaiveColor);
        case Ink::InverseTranspose: return look.readable(kInverseTransposeColor);
        case Ink::Cofactor: return look.readable(kCofactorColor);
        case Ink::Good: return look.good;
        case Ink::Bad: return look.bad;
    }
    return look.text;
}

MathStyle math_style(const Look& look, NumberSize numbers, float shrink) {
    const Fonts& f = look.fonts;
    return {f.letters,
            f.upright,
            f.small,
            numbers == NumberSize::Small ? f.small : f.numbers,
            f.tiny,
            nullptr,
            false,
            shrink * look.shrink,
            kEm * look.scale * shrink,
            std::max(1.0f, 1.25f * look.scale)};
}

float axis(const MathStyle& style) { return std::round(0.34f * style.em); }

void MathBox::add(const MathBox& other, float x, float y) {
    const auto moved = [&](ImVec2 p) { return ImVec2(p.x + x, p.y + y); };
    width = std::max(width, x + other.width);
    ascent = std::max(ascent, other.ascent - y);
    descent = std::max(descent, other.descent + y);
    for (Text text : other.texts) {
        text.at = moved(text.at);
        texts.push_back(std::move(text));
    }
    for (Stroke stroke : other.strokes) {
        for (ImVec2& point : stroke.points) point = moved(point);
        strokes.push_back(stroke);
    }
    for (Part part : other.parts) {
        part.low = moved(part.low);
        part.high = moved(part.high);
        parts.push_back(part);
    }
}

MathBox written(const MathStyle& style, const ImFont* font, std::string_view text, Ink ink) {
    // Every text of one font is as high as any other, so that lines of them keep their distance.
    const float size = font->FontSize * style.shrink, em = size / 1.362f;
    MathBox box;
    box.width = extent(style, font, text);
    box.ascent = std::round(kLetterAscent * em);
    box.descent = std::round(kLetterDescent * em);
    box.texts.push_back({font, size, {0, -std::round(font->Ascent * style.shrink)}, ink, std::string(text)});
    return box;
}

MathBox with_superscript(const MathStyle& style, MathBox base, std::string_view superscript, Ink ink) {
    const MathBox raised = written(style, style.script, superscript, ink);
    const float at =
        base.letter > 0.0f ? base.letter + std::round(0.05f * style.em) : base.width + std::round(0.06f * style.em);
    const bool tall = base.ascent > 1.2f * style.em;
    const float up = tall ? base.ascent - std::round(0.30f * style.em) : std::round(0.40f * style.em);
    base.letter = 0.0f;
    base.add(raised, at, -up);
    return base;
}

MathBox with_subscript(const MathStyle& style, MathBox base, std::string_view subscript, Ink ink) {
    const float letter = base.width;
    base.add(written(style, style.script, subscript, ink), letter, std::round(0.18f * style.em));
    base.letter = letter;
    return base;
}

MathBox parenthesised(const MathStyle& style, const MathBox& inside, Ink ink) {
    MathBox box;
    const float more = std::round(0.03f * style.em);
    const float ascent = inside.ascent + more, descent = inside.descent + more;
    const float wide = std::round(std::clamp(0.12f * (ascent + descent), 0.22f * style.em, 0.45f * style.em));
    const float gap = std::round(0.08f * style.em);
    box.add(inside, wide + 2 * gap);
    parenthesis(box, gap, true, ascent, descent, wide, style.weight, ink);
    parenthesis(box, box.width + gap, false, ascent, descent, wide, style.weight, ink);
    box.width += wide + 2 * gap;
    box.ascent = ascent;
    box.descent = descent;
    return box;
}

MathBox bracketed(const MathStyle& style, const MathBox& inside, Ink ink) {
    MathBox box;
    const float lip = std::round(0.22f * style.em), pad = std::round(0.06f * style.em),
                edge = std::round(0.06f * style.em);
    box.add(inside, edge + std::round(0.2f * style.em));
    box.ascent += pad;
    box.descent += pad;
    const float right = box.width + std::round(0.34f * style.em);
    for (const float side : {0.0f, 1.0f}) {
        const float x = side == 0.0f ? edge : right, inward = side == 0.0f ? lip : -lip;
        box.strokes.push_back({{ImVec2(x + inward, -box.ascent), ImVec2(x, -box.ascent), ImVec2(x, box.descent),
                                ImVec2(x + inward, box.descent)},
                               false,
                               style.weight,
                               ink});
    }
    box.width = right + edge;
    return box;
}

void strike(const MathStyle& style, MathBox& box, Ink ink) {
    const float y = -std::round(0.47f * box.ascent), over = std::round(0.1f * style.em);
    box.strokes.push_back(
        {{ImVec2(-over, y), ImVec2(-over, y), ImVec2(box.width + over, y), ImVec2(box.width + over, y)},
         false,
         std::max(1.0f, 0.8f * style.weight),
         ink});
}

void draw_math(ImDrawList& list, const Look& look, const MathBox& box, ImVec2 origin) {
    const auto at = [&](ImVec2 p) { return ImVec2(origin.x + p.x, origin.y + p.y); };
    for (const MathBox::Text& text : box.texts)
        list.AddText(text.font, text.size, at(text.at), packed(color_of(look, text.ink)), text.text.c_str(),
                     text.text.c_str() + text.text.size());
    for (const MathBox::Stroke& stroke : box.strokes) {
        const auto& p = stroke.points;
        const ImU32 color = packed(color_of(look, stroke.ink));
        if (stroke.curved) {
            list.AddBezierCubic(at(p[0]), at(p[1]), at(p[2]), at(p[3]), color, stroke.weight);
            continue;
        }
        for (const ImVec2& point : p) list.PathLineTo(at(point));
        list.PathStroke(color, 0, stroke.weight);
    }
}

const MathBox::Part* part_at(const MathBox& box, ImVec2 at) {
    const MathBox::Part* best = nullptr;
    float smallest = std::numeric_limits<float>::infinity();
    for (const MathBox::Part& part : box.parts) {
        if (at.x < part.low.x || at.x >= part.high.x || at.y < part.low.y || at.y >= part.high.y) continue;
        const float area = (part.high.x - part.low.x) * (part.high.y - part.low.y);
        if (area >= smallest) continue;
        smallest = area;
        best = &part;
    }
    return best;
}

}  // namespace normalscope

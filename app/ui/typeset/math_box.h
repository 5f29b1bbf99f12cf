#pragma once

#include "core/math/expression.h"
#include "ui/kit/style.h"

#include <imgui.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// What mathematics is written in; the theme makes it a colour when it is drawn.
enum class Ink { Plain, Dim, Faint, Tangent, Naive, InverseTranspose, Cofactor, Good, Bad };
Ink ink_of(Meaning meaning);
ImVec4 color_of(const Look& look, Ink ink);

/// The fonts and measures of mathematics, in physical pixels.
struct MathStyle {
    const ImFont *letters, *upright, *script, *numbers, *subscript_in_text;
    const ImFont* letters_in_text = nullptr;  ///< of names in sentences; null: as the words
    bool formula = false;                     ///< what is set is no sentence: "a" is a name
    float shrink = 1.0f;                      ///< for what would be too wide otherwise
    float em = 20.0f;                         ///< of the letters, shrunk
    float weight = 1.25f;                     ///< of brackets
};
enum class NumberSize { Usual, Small };
MathStyle math_style(const Look& look, NumberSize numbers = NumberSize::Usual, float shrink = 1.0f);

/// Which part of an expression: 1 is the whole, then three bits a level.
using Place = unsigned;
constexpr Place operand_of(Place place, std::size_t i) { return place << 3 | static_cast<Place>(i); }

/// Mathematics laid out: strokes, letters and what they mean, on whole pixels from its origin, the left end of the
/// baseline; y goes down.
struct MathBox {
    struct Text {
        const ImFont* font;
        float size;
        ImVec2 at;  ///< top left
        Ink ink;
        std::string text;
    };
    struct Stroke {
        std::array<ImVec2, 4> points;
        bool curved;  ///< a Bézier curve by these points
        float weight;
        Ink ink;
    };
    /// A symbol, or an operator with its operands.
    struct Part {
        ImVec2 low, high;
        Place place;
        Expression::Kind kind;
        Symbol symbol;
        Meaning meaning;
        bool as_number, has_number;
    };

    float width = 0.0f, ascent = 0.0f, descent = 0.0f;
    float letter = 0.0f;  ///< how far its letter reaches, above whose subscript a superscript stands; 0: none
    std::vector<Text> texts;
    std::vector<Stroke> strokes;
    std::vector<Part> parts;

    float height() const { return ascent + descent; }
    /// Puts another over this one, shifted; it grows to hold both.
    void add(const MathBox& other, float x, float y = 0.0f);
    /// Puts another to the right of this one.
    void append(const MathBox& other, float gap = 0.0f) { add(other, width + gap); }
};

MathBox written(const MathStyle& style, const ImFont* font, std::string_view text, Ink ink);
MathBox with_superscript(const MathStyle& style, MathBox base, std::string_view superscript, Ink ink);
MathBox with_subscript(const MathStyle& style, MathBox base, std::string_view subscript, Ink ink);
MathBox parenthesised(const MathStyle& style, const MathBox& inside, Ink ink);
/// Brackets about what is centred on the height of a minus sign.
MathBox bracketed(const MathStyle& style, const MathBox& inside, Ink ink);
/// Strikes everything through.
void strike(const MathStyle& style, MathBox& box, Ink ink);
/// How far above the baseline minus and equals signs stand: matrices are centred there.
float axis(const MathStyle& style);

/// `origin` on whole pixels.
void draw_math(ImDrawList& list, const Look& look, const MathBox& box, ImVec2 origin);
/// The innermost part there, as seen from the box's origin; null if none.
const MathBox::Part* part_at(const MathBox& box, ImVec2 at);

}  // namespace normalscope

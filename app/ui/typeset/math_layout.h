#pragma once

#include "core/math/expression.h"
#include "ui/typeset/math_box.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// Rows of cells, in brackets. The columns are as wide as their widest cell, which stands in their middle.
MathBox bracketed_cells(const MathStyle& style, const std::vector<std::vector<MathBox>>& rows, Ink ink);

/// What inks a matrix's entry.
using EntryInk = std::function<Ink(int row, int column)>;
/// A number as itself, anything larger in brackets, the decimal points of a column above each other. As wide for one
/// number as for any other from −9999 to 9999, so that nothing jitters as they change: all entries have as many
/// decimals as leave the largest four digits. A number too small for these stands in powers of ten; what is zero but
/// for rounding is 0. `struck`: a column that is struck through, or −1.
MathBox value_box(const MathStyle& style, const Value& value, const EntryInk& ink, Ink brackets, int struck = -1);
MathBox value_box(const MathStyle& style, const Value& value, Ink ink);

/// True for what is to be shown by its value.
using AsNumber = std::function<bool(Place place, const Expression& part)>;
/// One side of an equation, or what has none, with all its parts.
MathBox expression_box(const MathStyle& style, const Expression& expression, const AsNumber& as_number,
                       Place place = 1);

/// A name as equations have it: "n_world" is n with a subscript.
MathBox name_box(const MathStyle& style, Symbol symbol, Meaning meaning);

struct WordInks {
    Ink words = Ink::Plain;
    Meaning n_world = Meaning::InverseTranspose;
    std::string
        stands_out{};  ///< the one of "n_obj", "n_world" … that does, while the others are like words; empty: none
};
/// Words and mathematics (core/base/math_text.h) at `style.script`'s size, broken at spaces; n_obj and the like are in their
/// colours.
MathBox paragraph(const MathStyle& style, std::string_view text, float width, const WordInks& inks);
MathBox paragraph(const MathStyle& style, std::string_view text, float width, Ink ink, Meaning n_world);

struct Equation {
    MathBox left, right;
};
/// Their equals signs above each other as far as the width allows: where a line would not fit, a new column of signs
/// begins with it.
struct AlignedEquation {
    MathBox box;
    float sign = 0.0f;  ///< where its equals sign begins
};
std::vector<AlignedEquation> aligned(const MathStyle& style, std::span<const Equation> equations, float width);
/// What an equation takes beside others.
float width_of(const MathStyle& style, const Equation& equation);

}  // namespace normalscope

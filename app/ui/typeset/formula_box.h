#pragma once

#include "core/formula/print.h"
#include "ui/typeset/math_box.h"

#include <span>
#include <vector>

namespace normalscope {

/// A formula as mathematics has it: fractions, roots, exponents. Broken before its terms, or where these are too wide
/// before their factors or within their brackets, into lines of at most `width`; the first line's baseline is the box's.
struct FormulaBox {
    MathBox box;
    std::size_t lines = 1;
    bool broken_inside = false;  ///< a bracket, or a case, is broken into lines of its own
    bool whole = true;           ///< false: the rest was left out, or a part is wider than `width`
};
FormulaBox formula_box(const MathStyle& style, std::span<const formulas::Piece> pieces, float width,
                       std::size_t most_lines);

/// What stands left of the equals sign: f for 0, or ∂f/∂x, ∂f/∂y, ∂f/∂z.
MathBox derivative_name(const MathStyle& style, std::size_t which);

}  // namespace normalscope

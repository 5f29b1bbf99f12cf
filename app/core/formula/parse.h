#pragma once

#include "core/formula/graph.h"
#include "core/formula/syntax_error.h"

namespace normalscope::formulas {

/// Reads f(x, y, z) into the graph. Throws SyntaxError.
///
///     lhs = rhs           is lhs − rhs, as with ==; a leading "f(x, y, z) =" is left out, and so is a trailing ;
///     + - * / ^           also − · × ÷ **; ^ from the right, −x^2 is −(x^2), x^-2 is fine
///     ² ³ ⁻¹ √x |x|       as in print
///     2x  3(x+y)z  xy     products; they bind as * does: 1/2x is x/2. Of names that stand together directly before a
///                         bracket only x, y, z and one function at the end: ab(x) and sin2(x) are errors
///     sin(x)  sin 2x      without brackets a function takes the numbers and letters that follow, with their powers, up
///                         to an operator, a function or a bracket: sin 2x cos y is sin(2x)·cos(y)
///     sin^2 x             is (sin x)^2
///     cot sec log2 hypot  and more (functions.cpp) are read as what they are made of; arcsin is asin, ln is log
///     [ ] { }             are brackets, too, of whatever kind the other one is
///     pi π e              e is Euler's number, so it is none of the parameters a b c d f g h
///     2e3                 is 2000, but 2e x is 2·e·x
///
/// Letters in a row are split from the left into the longest names: axy is a·x·y, and acosx is acos x.
Id parse(Graph& graph, std::string_view text);

}  // namespace normalscope::formulas

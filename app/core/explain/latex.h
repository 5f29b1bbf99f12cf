#pragma once

// Numbers, matrices, expressions and plain text as LaTeX, for pdflatex with amsmath and color.

#include "core/math/expression.h"

#include <glm/vec3.hpp>

#include <string>
#include <string_view>

namespace normalscope {

/// In math mode: "0.7591", "1.5 \cdot 10^{-8}".
std::string latex_number(double number, double error = 0.0, int decimals = 4);
std::string latex_matrix(const Value& value);
/// An equation in names, or in numbers, in math mode, each symbol in the colour of its meaning: object, tangent, naive,
/// inversetranspose, cofactor must be defined.
std::string latex_names(const Expression& e);
std::string latex_numbers(const Expression& e);
/// What anybody may have written, as running text: special characters escaped, superscripts and the like as mathematics,
/// what a plain LaTeX has no sign for as "?".
std::string latex_text(std::string_view utf8);
/// "0.835,0.369,0.000"
std::string latex_color(const glm::vec3& srgb);

}  // namespace normalscope

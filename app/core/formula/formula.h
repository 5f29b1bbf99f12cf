#pragma once

#include "core/formula/graph.h"
#include "core/formula/syntax_error.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace normalscope::formulas {

/// f(x, y, z) with its exact partial derivatives, in one graph that holds nothing else.
struct Formula {
    Graph graph;
    Id f = 0;
    std::array<Id, 3> gradient{};
    std::string parameters;  ///< the letters of those that occur, in order: "ac"

    /// f, then the partial derivatives.
    std::array<Id, 4> expressions() const { return {f, gradient[0], gradient[1], gradient[2]}; }
};

/// What the user typed (parse.h says what is understood). Throws SyntaxError with the column; InputError where the
/// derivatives are too long to hold.
Formula read(std::string_view text);

/// What f is drawn and measured by: same_sign of it, with derivatives of its own; empty where that is f itself.
std::optional<Formula> tamed(const Formula& formula);

/// The letters of the parameters that occur in a formula; none where it cannot be read.
std::string parameters_in(std::string_view text);

}  // namespace normalscope::formulas

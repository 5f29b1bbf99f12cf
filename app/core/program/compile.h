#pragma once

#include "core/formula/graph.h"
#include "core/program/program.h"

#include <optional>

namespace normalscope::formulas {

/// With values for the parameters they become constants, and x^a is a polynomial where a is a whole number. Without,
/// they stay, as the graphics processor's uniforms.
Program compile(const Graph& graph, Id root, const std::optional<Parameters>& parameters);

}  // namespace normalscope::formulas

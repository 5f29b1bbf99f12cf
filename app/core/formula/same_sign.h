#pragma once

#include "core/formula/graph.h"

namespace normalscope::formulas {

/// An expression with the sign of this one wherever both have a value, so with the same zeros, whose numbers stay within
/// the range of doubles and floats more often: u²⁰⁰ − c as |u| − c^(1/200), exp(u) − c as u − ln c, u²⁰⁰ as u², and 10⁻³⁰⁰ u
/// as u. Where u = 0 makes the gradient zero it stays zero. The expression itself where there is nothing to gain.
Id same_sign(Graph& graph, Id root);

}  // namespace normalscope::formulas

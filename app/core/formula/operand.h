#pragma once

// What the parser's operators work on; for the parser only.

#include "core/formula/graph.h"
#include "core/formula/syntax_error.h"

#include <vector>

namespace normalscope::formulas {

/// Sums and products stay open as long as operands come: n operands are put in order once, not n times.
struct Operand {
    enum class Open { No, Sum, Product } open = Open::No;
    std::vector<Id> parts;
    std::size_t column = 1;
};

/// The operand as one expression. Throws SyntaxError where a number has become too large.
Id closed(Graph& graph, const Operand& operand);

/// a + b or a·b, still open for more.
Operand joined(Graph& graph, Operand::Open open, Operand a, Operand b);

}  // namespace normalscope::formulas

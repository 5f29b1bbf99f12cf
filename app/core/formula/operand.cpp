#include "core/formula/operand.h"

#include "core/formula/syntax_error.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace normalscope::formulas {

Id closed(Graph& graph, const Operand& operand) {
    if (operand.open == Operand::Open::No) return operand.parts[0];
    const Id id = operand.open == Operand::Open::Sum ? graph.add(operand.parts) : graph.multiply(operand.parts);
    if (graph.is_undefined(id)) throw SyntaxError(operand.column, "this number has become too large");
    return id;
}

Operand joined(Graph& graph, Operand::Open open, Operand a, Operand b) {
    for (Operand* o : {&a, &b})
        if (o->open != open) o->parts = {closed(graph, *o)};
    const std::size_t column = a.column;
    // The canonical order makes the order here indifferent: the few are copied to the many.
    if (a.parts.size() < b.parts.size()) std::swap(a, b);
    std::ranges::copy(b.parts, std::back_inserter(a.parts));
    return {open, std::move(a.parts), column};
}

}  // namespace normalscope::formulas

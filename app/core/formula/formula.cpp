#include "core/formula/formula.h"

#include "core/base/error.h"
#include "core/formula/parse.h"
#include "core/formula/same_sign.h"

namespace normalscope::formulas {

namespace {

// `draft` holds f with all that was built on the way.
Formula with_gradient(Graph& draft, Id f) {
    Formula result;
    result.parameters = parameters_of(draft, f);
    std::array<Id, 3> gradient{};
    for (int i = 0; i < 3; ++i) gradient[static_cast<std::size_t>(i)] = derivative(draft, f, i);
    result.f = copy(result.graph, draft, f);
    for (std::size_t i = 0; i < 3; ++i) result.gradient[i] = copy(result.graph, draft, gradient[i]);
    return result;
}

}  // namespace

Formula read(std::string_view text) {
    Graph draft;
    const Id f = parse(draft, text);
    return with_gradient(draft, f);
}

std::optional<Formula> tamed(const Formula& formula) {
    Graph draft;
    const Id f = copy(draft, formula.graph, formula.f), tame = same_sign(draft, f);
    if (tame == f) return std::nullopt;
    try {
        return with_gradient(draft, tame);
    } catch (const InputError&) {  // its derivatives are too long to hold
        return std::nullopt;
    }
}

std::string parameters_in(std::string_view text) {
    try {
        Graph graph;
        return parameters_of(graph, parse(graph, text));
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace normalscope::formulas

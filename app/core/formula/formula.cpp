#include "core/formula/formula.h"

#include "core/formula/parse.h"

namespace normalscope::formulas {

Formula read(std::string_view text) {
    Graph draft;  // with all that was built on the way
    const Id f = parse(draft, text);
    Formula result;
    result.parameters = parameters_of(draft, f);
    std::array<Id, 3> gradient{};
    for (int i = 0; i < 3; ++i) gradient[static_cast<std::size_t>(i)] = derivative(draft, f, i);
    result.f = copy(result.graph, draft, f);
    for (std::size_t i = 0; i < 3; ++i) result.gradient[i] = copy(result.graph, draft, gradient[i]);
    return result;
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

#include "core/scene/typed_number.h"

#include "core/base/decimal.h"
#include "core/formula/parse.h"
#include "core/program/compile.h"
#include "core/program/evaluate.h"
#include "core/program/program.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace normalscope {

std::optional<double> typed_number(std::string_view text) {
    std::string plain(text);
    constexpr std::string_view kUnit = "°";
    if (plain.ends_with(kUnit)) plain.resize(plain.size() - kUnit.size());
    if (plain.find('.') == plain.npos && std::ranges::count(plain, ',') == 1) std::ranges::replace(plain, ',', '.');

    const auto if_finite = [](double number) { return std::isfinite(number) ? std::optional(number) : std::nullopt; };
    if (const std::optional<double> number = decimal(plain)) return if_finite(*number);
    try {
        formulas::Graph graph;
        const formulas::Id root = formulas::parse(graph, plain);
        for (formulas::Id id = 0; id < graph.size(); ++id)  // in 0 x, too, of which nothing is left
            if (graph[id].op == formulas::Op::Variable || graph[id].op == formulas::Op::Parameter) return std::nullopt;
        const formulas::Program program = formulas::compile(graph, root, formulas::Parameters{});
        if (program.empty() || program.back().varies) return std::nullopt;
        return if_finite(formulas::value(program, glm::dvec3(0.0)));
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace normalscope

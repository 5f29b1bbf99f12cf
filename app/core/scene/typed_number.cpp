#include "core/scene/typed_number.h"

#include "core/formula/compile.h"
#include "core/formula/evaluate.h"
#include "core/formula/parse.h"
#include "core/formula/program.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace normalscope {

std::optional<double> typed_number(std::string_view text) {
    std::string plain(text);
    constexpr std::string_view kUnit = "°";
    if (plain.ends_with(kUnit)) plain.resize(plain.size() - kUnit.size());
    if (plain.find('.') == plain.npos && std::ranges::count(plain, ',') == 1) std::ranges::replace(plain, ',', '.');

    double number = 0.0;
    const char* const end = plain.data() + plain.size();
    if (const auto read = std::from_chars(plain.data(), end, number); read.ec == std::errc{} && read.ptr == end)
        return std::isfinite(number) ? std::optional(number) : std::nullopt;
    try {
        formulas::Graph graph;
        const formulas::Id root = formulas::parse(graph, plain);
        if (!formulas::parameters_of(graph, root).empty()) return std::nullopt;
        const formulas::Program program = formulas::compile(graph, root, formulas::Parameters{});
        if (program.empty() || program.back().varies) return std::nullopt;
        number = formulas::value(program, glm::dvec3(0.0));
    } catch (const InputError&) {
        return std::nullopt;
    }
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace normalscope

// formula_dump COUNT SEED: random formulas with their derivatives and values as JSON, for a test that asks a computer
// algebra system for the same.

#include "core/formula/syntax_error.h"
#include "core/program/compile.h"
#include "random_formula.h"

#include "core/formula/formula.h"
#include "core/formula/parse.h"
#include "core/formula/print.h"
#include "core/program/evaluate.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>

namespace {

using namespace normalscope::formulas;
using Json = nlohmann::json;

Json number(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }

Json dump(const std::string& text, normalscope::Random& random) {
    const Formula f = read(text);
    Json result{{"text", text}, {"f", to_text(f.graph, f.f)}};
    const Program program = compile(f.graph, f.f, kAllOne);
    std::array<Program, 3> symbolic;
    for (std::size_t i = 0; i < 3; ++i) {
        symbolic[i] = compile(f.graph, f.gradient[i], kAllOne);
        result["gradient"].push_back(to_text(f.graph, f.gradient[i]));
    }
    for (int k = 0; k < 5; ++k) {
        const glm::dvec3 p = random.vector(2.0);
        const Sample s = sample(program, p);
        Json point{{"at", {p.x, p.y, p.z}}, {"f", number(s.value)}};
        for (std::size_t i = 0; i < 3; ++i) {
            point["symbolic"].push_back(number(value(symbolic[i], p)));
            point["reverse"].push_back(number(s.gradient[static_cast<glm::length_t>(i)]));
        }
        result["points"].push_back(point);
    }
    return result;
}

// Empty where the formula divides by zero, or the like.
std::optional<Json> try_dump(const std::string& text, normalscope::Random& random) {
    try {
        return dump(text, random);
    } catch (const SyntaxError&) {
        return std::nullopt;
    }
}

}  // namespace

int main(int argc, char** argv) try {
    const int count = argc > 1 ? std::atoi(argv[1]) : 300;
    normalscope::Random random(argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 1);
    Json formulas = Json::array();
    while (static_cast<int>(formulas.size()) < count) {
        const std::string text = random_formula(random, {.explicit_only = true}, 3);
        if (const auto formula = try_dump(text, random)) formulas.push_back(*formula);
    }
    std::cout << formulas.dump(1) << "\n";
    return 0;
} catch (const std::exception& e) {
    std::cerr << "formula_dump: " << e.what() << "\n";
    return 1;
}

// Any bytes as a formula. With libFuzzer:
//     clang++ -std=c++20 -O1 -g -fsanitize=fuzzer,address,undefined -DNORMALSCOPE_LIBFUZZER -Iapp
//         tests/fuzz/formula_fuzz.cpp app/core/formula/*.cpp -o formula_fuzz && ./formula_fuzz -max_len=200
// Without, it is a program that makes its inputs itself: formula_fuzz [SECONDS [SEED]]. Either aborts at a mistake.

#include "core/formula/formula.h"
#include "core/formula/parse.h"
#include "core/formula/print.h"
#include "core/formula/syntax_error.h"
#include "core/program/compile.h"
#include "core/program/evaluate.h"
#include "core/program/glsl.h"
#include "core/program/polynomial.h"
#include "core/program/roots.h"

#include <glm/common.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace {

using namespace normalscope::formulas;

void require(bool holds, const char* what, std::string_view text) {
    if (holds) return;
    std::fprintf(stderr, "formula_fuzz: %s, for: %.*s\n", what, static_cast<int>(text.size()), text.data());
    std::abort();
}

bool reads_back(const Formula& f, const std::string& printed) {
    Graph again;
    try {
        return parse(again, printed) == copy(again, f.graph, f.f);
    } catch (const SyntaxError& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return false;
    }
}

void check(std::string_view text) {
    Formula f;
    try {
        f = read(text);
    } catch (const SyntaxError& e) {
        require(e.column >= 1 && e.column <= text.size() + 1, "an error beyond the text", text);
        require(std::string_view(e.what()).find('\n') == std::string_view::npos, "an error of several lines", text);
        return;
    } catch (const normalscope::InputError&) {
        return;  // the derivatives are too long
    }
    require(!f.graph.is_undefined(f.f), "a formula without a value", text);

    const std::string printed = to_text(f.graph, f.f);
    if (printed.size() <= kMostCharacters) {
        require(reads_back(f, printed), printed.c_str(), text);
    }
    for (const Id g : f.gradient)
        require(!to_latex(f.graph, g).empty() && !to_unicode(f.graph, g).empty(), "nothing printed", text);

    require(!to_glsl(compile(f.graph, f.f, std::nullopt)).source.empty(), "no shader", text);
    const Program program = compile(f.graph, f.f, kAllOne);
    (void)polynomial(f.graph, f.f, kAllOne);

    const Box box{{-0.7, 0.2, -1.1}, {0.4, 0.9, 1.3}};
    const IntervalSample bounds = sample(program, box);
    require(bounds.value.low <= bounds.value.high, "bounds that are none", text);
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        const Sample s = sample(program, glm::clamp(box.low + t * (box.high - box.low), box.low, box.high));
        require(std::isnan(s.value) || bounds.value.contains(s.value), "a value out of its bounds", text);
    }
    if (program.size() > 200) return;  // rays through long formulas take their time
    const std::vector<Root> roots = RayTracer(program).hits({-2, 0.1, 0.2}, {1, 0.03, -0.1}, 0.0, 4.0, Wanted::First);
    for (const Root& r : roots) require(r.t >= 0.0 && r.t <= 4.0, "a root off the ray", text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    check({reinterpret_cast<const char*>(data), size});
    return 0;
}

#ifndef NORMALSCOPE_LIBFUZZER
int main(int argc, char** argv) {
    constexpr std::array<std::string_view, 78> kParts{
        "x",      "y",         "z",     "a",      "e",      "pi",   "1",      "2",      "3",      "0",
        "0.5",    "1e9",       "1e300", "7/3",    "+",      "-",    "*",      "/",      "^",      "(",
        ")",      "(",         ")",     "|",      "=",      ",",    " ",      "sin",    "cos(",   "sqrt",
        "log(",   "exp(",      "²",     "⁻¹",     "√",      "tan ", "π",      "·",      "min(x,", "abs(",
        "max(",   "^(",        "1/3)",  "^2",     "^-1",    "−",    "where(", "asin(",  ".",      "9",
        "..",     "\xff",      "\x01",  "atan",   "acos(",  "^",    "x^2",    "+y^2",   "+z^2",   "-1",
        "sign(",  "f(x,y,z)=", "cosh",  "tanh(",  "asinh ", "[",    "}",      "floor(", "atan2(", "mod(x,",
        "log10(", "log2",      "ceil",  "hypot(", "pow(",   "==",   ";",      "cbrt("};
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(argc > 1 ? std::atoi(argv[1]) : 2);
    int i = 0;
    std::mt19937_64 random(argc > 2 ? static_cast<std::uint64_t>(std::atoll(argv[2])) : 1);
    for (; i % 100 != 0 || std::chrono::steady_clock::now() < end; ++i) {
        std::string text;
        for (std::uint64_t n = random() % (i % 10 == 0 ? 60 : 14); n-- > 0;) {
            // The likelier ones make longer formulas that can be read.
            text += kParts[random() % 3 == 0 ? random() % 8 : random() % kParts.size()];
            if (random() % 4 == 0) text += "+-*"[random() % 3];
        }
        check(text);
    }
    std::printf("%d formulas\n", i);
    return 0;
}
#endif

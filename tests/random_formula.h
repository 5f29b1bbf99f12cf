#pragma once

#include "random.h"

#include <string>

namespace normalscope::formulas {

/// What random formulas are made of.
struct Grammar {
    bool functions = true;
    bool piecewise = true;  ///< abs, min, max, and what jumps
    bool parameters = false;
    bool explicit_only = false;  ///< no implicit products, for readers that know none
};

/// A random formula as text, with at most 2^depth leaves.
inline std::string random_formula(Random& random, const Grammar& g, int depth) {
    const auto inner = [&] { return random_formula(random, g, depth - 1); };
    const auto leaf = [&]() -> std::string {
        switch (random.below(g.parameters ? 7 : 6)) {
            case 0:
            case 1: return "x";
            case 2: return "y";
            case 3: return "z";
            case 4: return std::to_string(random.below(5) + 1);
            case 5:
                return random.chance(0.5) ? "0." + std::to_string(random.below(99) + 1)
                                          : "(" + std::to_string(random.below(9) + 1) + "/" +
                                                std::to_string(random.below(9) + 1) + ")";
            default: return std::string(1, "abcdfgh"[random.below(7)]);
        }
    };
    if (depth == 0 || random.chance(0.1)) return leaf();
    switch (random.below(g.functions ? 15 : 8)) {
        case 0:
        case 1: return "(" + inner() + " + " + inner() + ")";
        case 2: return "(" + inner() + " - " + inner() + ")";
        case 3: return inner() + "*" + inner();
        case 4: return g.explicit_only ? "(" + inner() + ")*(" + inner() + ")" : "(" + inner() + ")(" + inner() + ")";
        case 5: return "(" + inner() + ")^" + std::to_string(random.below(4) + 1);
        case 6: return "(-" + inner() + ")";
        case 7: return "(" + inner() + ")/" + std::to_string(random.below(7) + 1);
        case 8: return "(" + inner() + ")/(" + inner() + " + 3)";
        case 9: return "sqrt(" + inner() + ")";
        case 10: {
            constexpr std::array kNames{"exp",  "log",  "sin",  "cos",  "tan",   "asin",  "acos",
                                        "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh"};
            return kNames[static_cast<std::size_t>(random.below(static_cast<int>(kNames.size())))] + ("(" + inner()) +
                   ")";
        }
        case 11: {
            constexpr std::array<const char*, 6> kNames{"ln", "log10", "log2", "cbrt", "hypot", "pow"};
            const auto k = static_cast<std::size_t>(random.below(6));
            return kNames[k] + ("(" + inner()) + (k == 4 ? ", y)" : k == 5 ? ", 2)" : ")");
        }
        case 12: {
            if (!g.piecewise) return "atan2(" + inner() + ", " + inner() + ")";
            constexpr std::array<const char*, 4> kNames{"sign", "floor", "ceil", "heaviside"};
            if (const int k = random.below(6); k < 4)
                return kNames[static_cast<std::size_t>(k)] + ("(" + inner()) + ")";
            return (random.chance(0.5) ? "mod(" : "atan2(") + inner() + ", " + inner() + ")";
        }
        case 13: return g.piecewise ? "abs(" + inner() + ")" : "sin(" + inner() + ")";
        default:
            if (!g.piecewise) return "(" + inner() + ")^(-2)";
            return (random.chance(0.5) ? "min(" : "max(") + inner() + ", " + inner() + ")";
    }
}

}  // namespace normalscope::formulas

#include "core/formula/same_sign.h"

#include "core/formula/formula.h"
#include "core/formula/print.h"
#include "core/program/compile.h"
#include "core/program/evaluate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace normalscope::formulas {
namespace {

std::string tame(const std::string& text) {
    const Formula formula = read(text);
    const auto tame = tamed(formula);
    return tame ? to_text(tame->graph, tame->f) : "as it is";
}

TEST(SameSign, WithinTheRangeOfNumbers) {
    const std::pair<const char*, const char*> cases[] = {
        {"x^200-1", "abs(x) - 1"},
        {"2^200-x^200", "2 - abs(x)"},
        {"(x+y)^201-1", "x + y - 1"},
        {"x^201+2^201", "x + 2"},
        {"x^200", "x^2"},
        {"x^199", "x^3"},
        {"x^100*y^100", "x^2*y^2"},
        {"x^100+y^100", "x^2 + y^2"},
        {"x^201-y^201", "x - y"},
        {"exp(x)-exp(y)", "x - y"},
        {"exp(-x^2)-1", "-x^2"},
        {"exp(-exp(x))-exp(-1)", "-x"},
        {"exp(-100x^2)=exp(-100)", "-100*x^2 + 100"},
        {"sinh(x)-1e9", "x - asinh(1e9)"},
        {"1e9-2sinh(x)", "asinh(5e8) - x"},
        {"cosh(x)-1e9", "abs(x) - acosh(1e9)"},
    };
    for (const auto& [text, expected] : cases) {
        const Formula wanted = read(expected), formula = read(text);
        const auto tame = tamed(formula);
        ASSERT_TRUE(tame) << text;
        EXPECT_EQ(to_text(tame->graph, tame->f), to_text(wanted.graph, wanted.f)) << text;
    }
}

TEST(SameSign, LeavesTheRestAlone) {
    for (const char* text : {"x^2+y^2+z^2-1", "x^4-1", "exp(x)", "exp(x)+1", "x*exp(x)-1", "x^200+y", "sin(x)^100-x",
                             "1/x^100-1", "sinh(x)-5", "cosh(x)+9", "a*x^2-1", "x^x-0.5", "3(x^2+y^2)-1"})
        EXPECT_EQ(tame(text), "as it is") << text;
}

// And for whatever else it rewrites: never another sign, as far as doubles tell.
TEST(SameSign, IsTheSameSign) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-1.6, 1.6);
    for (const char* text : {"x^200-1e-300",
                             "exp(-x^2*1000)-1e-300",
                             "3cosh(400x)-1e100",
                             "-sinh(300x^2)-1e99",
                             "exp(-exp(10x))-1e-300",
                             "x^100*y^100-1e-30",
                             "1e-200(x^2+y^2+z^2-1)",
                             "1e300(x^2+y^2+z^2-1)",
                             "(x^2+y^2+z^2-1)^31*1e-30",
                             "0.5-x^50*y^50",
                             "exp(9x)*y^40-exp(5z)",
                             "-exp(x)+exp(-y)",
                             "-(x+y)^31-3",
                             "3-2(x+y)^31",
                             "(x^2-y)^22*z^24-1",
                             "exp(x+y)^30-2",
                             "2x^30-3y^30",
                             "x^31*y^31-1",
                             "-x^30-y^30",
                             "(x-1)^30+(y-1)^40",
                             "x^30*exp(y)-exp(-z)*y^30",
                             "e^30*x^22-pi*y^24",
                             "-2x^21+5",
                             "x^30-(y+1)^28"}) {
        const Formula formula = read(text);
        const auto tame = tamed(formula);
        ASSERT_TRUE(tame) << text;
        const Program f = compile(formula.graph, formula.f, kAllOne), g = compile(tame->graph, tame->f, kAllOne);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 p(coordinate(random), coordinate(random), coordinate(random));
            const double a = value(f, p), b = value(g, p);
            if (!std::isnormal(a) || std::abs(b) < 1e-9) continue;
            EXPECT_EQ(a < 0.0, b < 0.0) << text << " at " << p.x << ' ' << p.y << ' ' << p.z;
        }
    }
}

}  // namespace
}  // namespace normalscope::formulas

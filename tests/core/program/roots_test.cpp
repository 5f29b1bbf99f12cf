#include "core/program/roots.h"
#include "core/formula/parse.h"
#include "core/program/compile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace normalscope::formulas {
namespace {

Program program(std::string_view text) {
    Graph graph;
    const Id f = parse(graph, text);
    return compile(graph, f, kAllOne);
}

// Along the x axis, from 0 to 10, by both ways.
void expect_roots(std::string_view text, const std::vector<Root>& expected, double tolerance = 1e-12) {
    const Program f = program(text);
    const RayTracer tracer(f);
    for (const bool general : {false, true}) {
        if (!general && !tracer.is_polynomial()) continue;
        const glm::dvec3 o(0, 0.3, -0.2), d(1, 0, 0);
        const std::vector<Root> all =
            general ? roots_by_intervals(f, o, d, 0, 10, Wanted::All) : tracer.hits(o, d, 0, 10, Wanted::All);
        const std::vector<Root> first =
            general ? roots_by_intervals(f, o, d, 0, 10, Wanted::First) : tracer.hits(o, d, 0, 10, Wanted::First);
        ASSERT_EQ(all.size(), expected.size()) << text << (general ? " by intervals" : "");
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_NEAR(all[i].t, expected[i].t, tolerance) << text << (general ? " by intervals" : "");
            EXPECT_EQ(all[i].touches, expected[i].touches) << text << (general ? " by intervals" : "");
        }
        ASSERT_EQ(first.size(), std::min<std::size_t>(expected.size(), 1)) << text << (general ? " by intervals" : "");
        if (!first.empty()) {
            EXPECT_NEAR(first[0].t, expected[0].t, tolerance) << text;
        }
    }
}

TEST(FormulaRoots, SingleOnes) {
    expect_roots("x - 3", {{3}});
    expect_roots("x^2 - 25", {{5}});
    expect_roots("(x-1)(x-2)(x-7)", {{1}, {2}, {7}});
    expect_roots("x^2 + 1", {});
    expect_roots("x + 1", {});
    expect_roots("x^9 - 512", {{2}});
    expect_roots("x - 5", {{5}});  // in the middle
}

TEST(FormulaRoots, AtTheEnds) {
    expect_roots("x", {{0}}, 1e-12);
    expect_roots("x - 10", {{10}}, 1e-12);
    expect_roots("x(x-10)", {{0}, {10}}, 1e-12);
}

TEST(FormulaRoots, TouchingOnes) {
    expect_roots("(x-3)^2", {{3, true}}, 1e-7);
    expect_roots("x^2 - 6x + 9", {{3, true}}, 1e-7);
    expect_roots("(x-3)^2(x-7)", {{3, true}, {7}}, 1e-7);
    expect_roots("(x-3)^2(x-4)^2", {{3, true}, {4, true}}, 1e-7);
}

TEST(FormulaRoots, OfHigherMultiplicity) {
    const RayTracer triple(program("(x-3)^3(x-8)"));
    const std::vector<Root> roots = triple.hits({0, 0, 0}, {1, 0, 0}, 0, 10, Wanted::All);
    ASSERT_EQ(roots.size(), 2u);
    EXPECT_NEAR(roots[0].t, 3.0, 1e-5);
    EXPECT_FALSE(roots[0].touches);
    EXPECT_NEAR(roots[1].t, 8.0, 1e-10);

    const RayTracer quadruple(program("(x-3)^4"));
    const std::vector<Root> one = quadruple.hits({0, 0, 0}, {1, 0, 0}, 0, 10, Wanted::All);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_NEAR(one[0].t, 3.0, 1e-3);
    EXPECT_TRUE(one[0].touches);
}

TEST(FormulaRoots, ThinSheets) {
    expect_roots("(x-3)^2 - 1e-8", {{2.9999}, {3.0001}}, 1e-10);
    expect_roots("(x-3)^2 - 1e-10", {{2.99999}, {3.00001}}, 1e-8);
    expect_roots("(x-3)^2 + 1e-10", {});  // a near miss
}

TEST(FormulaRoots, WithinTheSurface) {
    const RayTracer plane(program("z (x-2)"));
    for (const Wanted wanted : {Wanted::First, Wanted::All}) {
        const std::vector<Root> roots = plane.hits({0, 1, 0}, {1, 0, 0}, 0, 10, wanted);
        ASSERT_EQ(roots.size(), 1u);
        EXPECT_EQ(roots[0].t, 0.0);
        EXPECT_TRUE(roots[0].touches);
    }
}

TEST(FormulaRoots, OfFunctions) {
    expect_roots("sin(x)", {{0}, {std::acos(-1.0)}, {2 * std::acos(-1.0)}, {3 * std::acos(-1.0)}}, 1e-9);
    expect_roots("exp(x) - 100", {{std::log(100.0)}}, 1e-10);
    expect_roots("sqrt(x) - 2", {{4}}, 1e-10);
    expect_roots("log(x-1)", {{2}}, 1e-10);
    expect_roots("abs(x-4) - 1", {{3}, {5}}, 1e-9);
    expect_roots("(x-4)^(1/3)", {{4}}, 1e-8);
    expect_roots("1/(x-4)", {});  // a pole is no root
    expect_roots("tan(x-5) + 0z", {{5 - std::acos(-1.0)}, {5}, {5 + std::acos(-1.0)}}, 1e-9);
    expect_roots("sin(x) - 1", {{std::acos(-1.0) / 2, true}, {5 * std::acos(-1.0) / 2, true}}, 1e-6);
    expect_roots("x^1e9 + 1", {});
    expect_roots("1/(x-4)^2", {});
    expect_roots("exp(1/(x-2)) - 2", {{2 + 1 / std::log(2.0)}}, 1e-9);  // beside a pole it overflows
    expect_roots("floor(x) - 3.5", {});                                 // nor is a jump
    expect_roots("mod(x, 4) - 1", {{1}, {5}, {9}}, 1e-9);
    expect_roots("(x-2)/(x-4)^3", {{2}}, 1e-9);
    expect_roots("sqrt(-1-x^2)", {});
}

}  // namespace
}  // namespace normalscope::formulas

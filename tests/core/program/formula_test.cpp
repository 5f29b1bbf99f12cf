#include "core/formula/formula.h"
#include "core/formula/parse.h"
#include "core/formula/print.h"
#include "core/program/compile.h"
#include "core/program/evaluate.h"
#include "core/program/glsl.h"
#include "core/program/polynomial.h"

#include <gtest/gtest.h>

#include <cmath>

namespace normalscope::formulas {
namespace {

std::array<std::string, 3> gradient_of(std::string_view text) {
    const Formula f = read(text);
    return {to_unicode(f.graph, f.gradient[0]), to_unicode(f.graph, f.gradient[1]), to_unicode(f.graph, f.gradient[2])};
}
using Three = std::array<std::string, 3>;

Program program(std::string_view text, const Parameters& parameters = kAllOne) {
    Graph graph;
    const Id f = parse(graph, text);
    return compile(graph, f, parameters);
}

TEST(Formula, GradientsAsInATextbook) {
    EXPECT_EQ(gradient_of("x^2+y^2+z^2-1"), (Three{"2x", "2y", "2z"}));
    EXPECT_EQ(gradient_of("x^2/a^2 + y^2/b^2 = z"), (Three{"2x/a²", "2y/b²", "−1"}));
    EXPECT_EQ(gradient_of("x^3 + x^2 z^2 - y^2"), (Three{"2xz² + 3x²", "−2y", "2x² z"}));
    EXPECT_EQ(gradient_of("(x^2+y^2-1)^2 + z^2"), (Three{"4x(x² + y² − 1)", "4y(x² + y² − 1)", "2z"}));
    EXPECT_EQ(
        gradient_of("sin x cos y + sin y cos z + sin z cos x"),
        (Three{"cos(x) cos(y) − sin(x) sin(z)", "cos(y) cos(z) − sin(x) sin(y)", "cos(x) cos(z) − sin(y) sin(z)"}));
    EXPECT_EQ(gradient_of("sqrt(x) + log(y) + atan(z)"), (Three{"1/(2√x)", "1/y", "1/(z² + 1)"}));
    EXPECT_EQ(gradient_of("sinh(x) + cosh(y) + tanh(z)"), (Three{"cosh(x)", "sinh(y)", "1/cosh(z)²"}));
    EXPECT_EQ(gradient_of("asinh(x) + acosh(y) + atanh(z)"), (Three{"1/√(x² + 1)", "1/√(y² − 1)", "1/(1 − z²)"}));
    EXPECT_EQ(gradient_of("exp(-x^2) + tan(y) + 2^z"), (Three{"−2x e^(−x²)", "1/cos(y)²", "log(2)·2^z"}));
    EXPECT_EQ(gradient_of("abs(x) + max(y, z)"), (Three{"sign(x)", "where(1, z − y, 0)", "where(0, z − y, 1)"}));
    EXPECT_EQ(gradient_of("x^y"), (Three{"x^(y − 1) y", "x^y log(x)", "0"}));
    EXPECT_EQ(gradient_of("x^1e9"), (Three{"1000000000x⁹⁹⁹⁹⁹⁹⁹⁹⁹", "0", "0"}));
    EXPECT_EQ(gradient_of("1/3"), (Three{"0", "0", "0"}));
}

TEST(Formula, ParametersThatOccur) {
    EXPECT_EQ(read("h x + c^a + 0 b").parameters, "ach");
    EXPECT_EQ(read("e x").parameters, "");
}

TEST(Formula, RealRootsOfNegativeNumbers) {
    EXPECT_DOUBLE_EQ(value(program("x^(1/3)"), {-8, 0, 0}), -2.0);
    EXPECT_DOUBLE_EQ(value(program("x^(2/3)"), {-8, 0, 0}), 4.0);
    EXPECT_DOUBLE_EQ(value(program("x^-3"), {-2, 0, 0}), -0.125);
    EXPECT_TRUE(std::isnan(value(program("x^(1/2)"), {-4, 0, 0})));
    EXPECT_TRUE(std::isnan(value(program("x^y"), {-4, 0.5, 0})));
    EXPECT_DOUBLE_EQ(value(program("x^y"), {-4, 3, 0}), -64.0);
    EXPECT_DOUBLE_EQ(value(program("x^a", {2}), {-4, 0, 0}), 16.0);
    EXPECT_EQ(polynomial_degree(program("x^a", {2}), 9), 2);
}

TEST(Formula, WhatHasNoValueIsNaN) {
    for (const auto* text :
         {"1/x", "log(x)", "x^-2", "sqrt(-1-x^2)", "asin(x+2)", "0^(-x^2)", "log(-a)+x", "1/(a-1)+x"})
        EXPECT_TRUE(std::isnan(value(program(text), {0, 0, 0}))) << text;
    EXPECT_EQ(value(program("x^1e9"), {0.5, 0, 0}), 0.0);
    EXPECT_TRUE(std::isnan(value(program("x^1e9"), {2, 0, 0})));
}

TEST(Formula, Intervals) {
    const auto over = [](std::string_view text, double low, double high) {
        return value(program(text), Box{glm::dvec3(low), glm::dvec3(high)});
    };
    const auto near = [](const Interval& i, double low, double high) {
        return i.low <= low && high <= i.high && low - i.low < 1e-12 && i.high - high < 1e-12;
    };
    using D = Interval::Defined;
    EXPECT_TRUE(near(over("x^2", -1, 2), 0, 4));
    EXPECT_TRUE(near(over("x^3", -1, 2), -1, 8));
    EXPECT_TRUE(near(over("x^(2/3)", -1, 8), 0, 4));
    EXPECT_TRUE(near(over("x^(1/3)", -1, 8), -1, 2));
    EXPECT_TRUE(near(over("sin(x)", 0, 3), 0, 1));
    EXPECT_TRUE(near(over("cos(x)", 3, 4), -1, std::cos(4.0)));
    EXPECT_TRUE(near(over("abs(x)", -3, 2), 0, 3));
    EXPECT_TRUE(near(over("1/x", 1, 2), 0.5, 1));
    EXPECT_EQ(over("1/x", 1, 2).defined, D::Everywhere);
    EXPECT_EQ(over("1/x", -1, 2).low, -INFINITY);
    EXPECT_EQ(over("1/x", -1, 2).defined, D::Somewhere);
    EXPECT_EQ(over("1/x", 0, 0).defined, D::Nowhere);
    EXPECT_EQ(over("sqrt(x)", -1, 4).defined, D::Somewhere);
    EXPECT_TRUE(near(over("sqrt(x)", -1, 4), 0, 2));
    EXPECT_EQ(over("sqrt(x)", -2, -1).defined, D::Nowhere);
    EXPECT_EQ(over("log(x)", 0, 1).low, -INFINITY);
    EXPECT_EQ(over("log(x)", -1, 0).defined, D::Nowhere);
    EXPECT_EQ(over("tan(x)", 1, 2).defined, D::Somewhere);
    EXPECT_EQ(over("x^1e9", 0, 2).high, INFINITY);
    EXPECT_FALSE(std::isnan(over("x^1e9 - x^1e9 y", 0, 2).low));
}

TEST(Formula, WhatIsNotTakenHasNoPartInTheGradient) {
    const auto at = [](std::string_view text, glm::dvec3 p) {
        const Program f = program(text);
        const Sample one = sample(f, p);
        std::vector<Sample> many(9);
        samples(f, std::vector<glm::dvec3>(9, p), many);
        EXPECT_EQ(many.back().gradient, one.gradient) << text;
        return one.gradient;
    };
    const glm::dvec3 p(1, 0.5, 0);
    EXPECT_EQ(at("where(sqrt(-x), x, x^2+y)", p), glm::dvec3(2, 1, 0));
    EXPECT_EQ(at("where(x^2+y, x-2, log(-x))", p), glm::dvec3(2, 1, 0));
    EXPECT_EQ(at("where(where(log(-x), sqrt(-x), x), x, x^2+y)", p), glm::dvec3(2, 1, 0));
    EXPECT_EQ(at("min(x^2+y, sqrt(x^2-1)+9)", p), glm::dvec3(2, 1, 0));  // whose slope is infinite here
    EXPECT_EQ(at("max(x^2+y, sqrt(x^2-1)-9)", p), glm::dvec3(2, 1, 0));
}

TEST(Formula, PolynomialsAreMultipliedOutExactly) {
    Graph graph;
    const auto p = polynomial(graph, parse(graph, "(x+y/3)^2 - x^2 + 2z(x - 1)"));
    ASSERT_TRUE(p);
    EXPECT_TRUE(p->exact);
    EXPECT_EQ(p->degree(), 2);
    const std::map<Polynomial::Exponents, Number, std::greater<>> expected{
        {{1, 1, 0}, Number::ratio(2, 3)}, {{0, 2, 0}, Number::ratio(1, 9)}, {{1, 0, 1}, 2}, {{0, 0, 1}, -2}};
    EXPECT_EQ(p->terms, expected);
    EXPECT_EQ(polynomial(graph, parse(graph, "(x+1)^2-x^2"))->degree(), 1);
    EXPECT_FALSE(polynomial(graph, parse(graph, "sqrt(2) x"))->exact);
    EXPECT_EQ(polynomial(graph, parse(graph, "x^a"), Parameters{3})->degree(), 3);
    for (const auto* text : {"sin(x)", "1/x", "x^1e9", "x^25", "x^y", "x^a", "(x+y+z+1)^30"})
        EXPECT_FALSE(polynomial(graph, parse(graph, text))) << text;
}

TEST(Formula, ShadersOnlyUseWhatBothGlslsHave) {
    Graph graph;
    const auto glsl = [&](std::string_view text) { return to_glsl(compile(graph, parse(graph, text), std::nullopt)); };
    const Glsl sphere = glsl("x^2+y^2+z^2-a");
    EXPECT_NE(sphere.source.find("uniform float formula_a;\n"), std::string::npos);
    EXPECT_EQ(sphere.source.find("pow("), std::string::npos);
    EXPECT_TRUE(sphere.defined_everywhere);
    EXPECT_FALSE(glsl("sqrt(x) + y").defined_everywhere);
    EXPECT_NE(glsl("sqrt(x) + y").source.find("p.x >= 0.0"), std::string::npos);
    EXPECT_NE(glsl("x^(1/3)").source.find("odd_pow(p.x"), std::string::npos);
    EXPECT_EQ(glsl("1e300 x").source.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace normalscope::formulas

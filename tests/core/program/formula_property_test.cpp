// Formulas made at random, from fixed seeds: what each part of the engine says of them must agree with the others.

#include "core/formula/syntax_error.h"
#include "core/program/compile.h"
#include "random_formula.h"

#include "core/formula/formula.h"
#include "core/formula/parse.h"
#include "core/formula/print.h"
#include "core/program/evaluate.h"
#include "core/program/polynomial.h"
#include "core/program/roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace normalscope::formulas {
namespace {

constexpr Parameters kParameters{0.7, -1.3, 2.0, 0.5, 1.1, 3.0, -0.4};
constexpr Grammar kEverything{.parameters = true};

// Random formulas that can be read; some divide by zero, and say so.
template <class Check>
void for_random_formulas(std::uint64_t seed, int count, const Grammar& grammar, int depth, Check&& check) {
    Random random(seed);
    int refused = 0;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const std::string text = random_formula(random, grammar, depth);
        SCOPED_TRACE(text);
        try {
            check(read(text), random);
        } catch (const SyntaxError& e) {
            const std::string reason = e.what();
            EXPECT_TRUE(reason.find("value") != reason.npos || reason.find("divides by zero") != reason.npos) << reason;
            ++refused;
        }
    }
    EXPECT_LT(refused, count / 5);
}

bool close(double a, double b, double relative, double scale = 1.0) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return std::abs(a - b) <= relative * std::max({std::abs(a), std::abs(b), scale});
}

TEST(Formula, WhatIsPrintedReadsBackTheSame) {
    for_random_formulas(1, 2000, kEverything, 5, [](const Formula& f, Random&) {
        for (const Id e : {f.f, f.gradient[0], f.gradient[1], f.gradient[2]}) {
            Graph graph;
            const Id original = copy(graph, f.graph, e);
            const std::string text = to_text(f.graph, e), unicode = to_unicode(f.graph, e);
            if (text.size() > kMostCharacters || text.find("undefined") != std::string::npos) continue;
            EXPECT_EQ(parse(graph, text), original) << text << "\nread back as\n" << to_text(graph, parse(graph, text));
            if (unicode.find("||") != std::string::npos || unicode.find('|') != unicode.rfind('|'))
                continue;  // nested bars are ambiguous
            EXPECT_EQ(parse(graph, unicode), original) << unicode << "\nread back as\n"
                                                       << to_unicode(graph, parse(graph, unicode));
        }
    });
}

TEST(Formula, DerivativesAgreeWithEachOtherAndWithDifferences) {
    int compared = 0, with_differences = 0;
    for_random_formulas(2, 600, kEverything, 4, [&](const Formula& f, Random& random) {
        const Program value_program = compile(f.graph, f.f, kParameters);
        std::array<Program, 3> symbolic;
        for (std::size_t i = 0; i < 3; ++i) symbolic[i] = compile(f.graph, f.gradient[i], kParameters);
        for (int k = 0; k < 10; ++k) {
            const glm::dvec3 p = random.vector(2.0);
            const Sample s = sample(value_program, p);
            if (std::isnan(s.value) || !std::isfinite(glm::length(s.gradient)) || glm::length(s.gradient) > 1e6)
                continue;
            for (glm::length_t i = 0; i < 3; ++i) {
                const double exact = value(symbolic[static_cast<std::size_t>(i)], p);
                if (std::isnan(exact)) continue;
                ++compared;
                EXPECT_TRUE(close(exact, s.gradient[i], 1e-7)) << exact << " and " << s.gradient[i];

                // Two step sizes that agree: there is no kink or pole near, and rounding does not yet count.
                const auto difference = [&](double h) {
                    glm::dvec3 step(0.0);
                    step[i] = h;
                    return (value(value_program, p + step) - value(value_program, p - step)) / (2 * h);
                };
                const double coarse = difference(1e-4), fine = difference(5e-5);
                const bool grainy = std::abs(s.value) > 1e6;  // the difference is but rounding
                const auto whole = value(value_program, Box{p - 1e-4, p + 1e-4}).defined;
                if (std::isnan(coarse) || !close(coarse, fine, 1e-6) || grainy) continue;
                if (whole != Interval::Defined::Everywhere) continue;  // jumps
                ++with_differences;
                EXPECT_TRUE(close(s.gradient[i], fine, 1e-4)) << s.gradient[i] << " and " << fine;
            }
        }
    });
    EXPECT_GT(compared, 5000);
    EXPECT_GT(with_differences, compared / 3);
}

TEST(Formula, ManyPointsAtOnceAreTheSame) {
    for_random_formulas(3, 200, kEverything, 4, [&](const Formula& f, Random& random) {
        const Program program = compile(f.graph, f.f, kParameters);
        std::vector<glm::dvec3> points;
        for (int k = 0; k < 19; ++k) points.push_back(random.vector(2.0));
        std::vector<double> many(points.size());
        std::vector<Sample> many_samples(points.size());
        values(program, points, many);
        samples(program, points, many_samples);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Sample one = sample(program, points[k]);
            EXPECT_TRUE(close(many[k], one.value, 1e-12));
            EXPECT_TRUE(close(many_samples[k].value, value(program, points[k]), 1e-12));
            for (glm::length_t i = 0; i < 3; ++i)
                EXPECT_TRUE(!std::isfinite(one.gradient[i]) ||
                            close(many_samples[k].gradient[i], one.gradient[i], 1e-12));
        }
    });
}

TEST(Formula, IntervalsHoldAllValues) {
    for_random_formulas(4, 1500, kEverything, 4, [&](const Formula& f, Random& random) {
        const Program program = compile(f.graph, f.f, kParameters);
        for (int k = 0; k < 4; ++k) {
            const glm::dvec3 middle = random.vector(2.0),
                             half = std::pow(10.0, random.uniform(-6.0, 0.5)) * glm::abs(random.vector());
            const IntervalSample bounds = sample(program, Box{middle - half, middle + half});
            EXPECT_FALSE(std::isnan(bounds.value.low) || std::isnan(bounds.value.high));
            EXPECT_LE(bounds.value.low, bounds.value.high);
            const Interval value_only = value(program, Box{middle - half, middle + half});
            EXPECT_EQ(value_only.low, bounds.value.low);
            for (int n = 0; n < 20; ++n) {
                const glm::dvec3 p = middle + half * random.vector();
                const Sample s = sample(program, p);
                if (std::isnan(s.value)) {
                    const bool overflow = bounds.value.high > 1e300 || bounds.value.low < -1e300;
                    EXPECT_TRUE(bounds.value.defined != Interval::Defined::Everywhere || overflow);
                    continue;
                }
                EXPECT_TRUE(bounds.value.contains(s.value))
                    << bounds.value.low << " " << s.value << " " << bounds.value.high;
                EXPECT_NE(bounds.value.defined, Interval::Defined::Nowhere);
                for (std::size_t i = 0; i < 3; ++i) {
                    EXPECT_FALSE(std::isnan(bounds.gradient[i].low) || std::isnan(bounds.gradient[i].high));
                    const double d = s.gradient[static_cast<glm::length_t>(i)];
                    EXPECT_TRUE(!std::isfinite(d) || bounds.gradient[i].contains(d))
                        << bounds.gradient[i].low << " " << d << " " << bounds.gradient[i].high;
                }
            }
        }
    });
}

constexpr Grammar kPolynomials{.functions = false, .parameters = true};

TEST(Formula, PolynomialsAlongRays) {
    int polynomials = 0;
    for_random_formulas(5, 600, kPolynomials, 4, [&](const Formula& f, Random& random) {
        const Program program = compile(f.graph, f.f, kParameters);
        const auto degree = polynomial_degree(program, kMostDegree);
        const auto expanded = polynomial(f.graph, f.f, kParameters);
        if (!degree) return;
        ++polynomials;
        ASSERT_TRUE(expanded);
        EXPECT_LE(expanded->degree(), *degree);
        const glm::dvec3 o = random.vector(2.0), d = random.vector(2.0);
        const auto along = along_ray(program, o, d);
        ASSERT_TRUE(along);
        for (int k = 0; k < 10; ++k) {
            const double t = random.uniform(-1.0, 1.0);
            double by_ray = 0.0, size = 0.0, by_terms = 0.0, terms_size = 0.0;
            for (int i = along->degree; i >= 0; --i) {
                by_ray = by_ray * t + along->c[static_cast<std::size_t>(i)];
                size += std::abs(along->c[static_cast<std::size_t>(i)]);
            }
            const glm::dvec3 p = o + t * d;
            for (const auto& [e, c] : expanded->terms) {
                by_terms += c.value() * std::pow(p.x, e[0]) * std::pow(p.y, e[1]) * std::pow(p.z, e[2]);
                terms_size += std::abs(c.value()) * std::pow(std::abs(p.x), e[0]) * std::pow(std::abs(p.y), e[1]) *
                              std::pow(std::abs(p.z), e[2]);
            }
            const double exact = value(program, p);
            EXPECT_LE(std::abs(by_ray - exact), 4.0 * along->noise + 1e-14 * size);
            EXPECT_LE(std::abs(by_terms - exact), 4.0 * along->noise + 1e-12 * terms_size);
        }
    });
    EXPECT_GT(polynomials, 400);
}

// Products of factors with known roots, and factors without any, multiplied out.
TEST(Formula, RootsAreFoundHoweverTheyLie) {
    Random random(6);
    for (int i = 0; i < 5000 && !testing::Test::HasFailure(); ++i) {
        std::vector<double> roots;
        RayPolynomial p;
        p.c[0] = random.chance(0.5) ? 1.0 : -1.0;
        const auto multiply = [&](double constant, double linear, double square) {
            RayPolynomial q;
            q.degree = p.degree + (square != 0.0 ? 2 : 1);
            for (std::size_t k = 0; k <= static_cast<std::size_t>(p.degree); ++k) {
                q.c[k] += p.c[k] * constant;
                q.c[k + 1] += p.c[k] * linear;
                if (square != 0.0) q.c[k + 2] += p.c[k] * square;
            }
            p = q;
        };
        for (int n = random.below(6); n > 0; --n) {
            const double r = random.uniform(-1.5, 1.5);
            roots.push_back(r);
            multiply(-r, 1.0, 0.0);
        }
        for (int n = random.below(4); n > 0; --n) {  // (t − r)² + s²
            const double r = random.uniform(-1.0, 1.0), s = random.uniform(0.05, 1.0);
            multiply(r * r + s * s, -2.0 * r, 1.0);
        }
        std::ranges::sort(roots);
        bool apart = true;
        for (std::size_t k = 1; k < roots.size(); ++k) apart = apart && roots[k] - roots[k - 1] > 1e-3;
        for (const double r : roots) apart = apart && std::abs(std::abs(r) - 1.0) > 1e-6;
        if (!apart) continue;
        std::erase_if(roots, [](double r) { return std::abs(r) > 1.0; });

        const std::vector<Root> found = RootFinder(p.degree)(p, Wanted::All);
        ASSERT_EQ(found.size(), roots.size());
        for (std::size_t k = 0; k < roots.size(); ++k) {
            EXPECT_NEAR(found[k].t, roots[k], 1e-7);
            EXPECT_FALSE(found[k].touches);
        }
        const std::vector<Root> first = RootFinder(p.degree)(p, Wanted::First);
        ASSERT_EQ(first.size(), std::min<std::size_t>(roots.size(), 1));
        EXPECT_TRUE(roots.empty() || first[0].t == found[0].t);
    }
}

TEST(Formula, BothWaysToTraceRaysAgree) {
    const std::string phi = "((1+sqrt(5))/2)";
    const std::string barth =
        "4(" + phi + "^2x^2-y^2)(" + phi + "^2y^2-z^2)(" + phi + "^2z^2-x^2)-(1+2" + phi + ")(x^2+y^2+z^2-1)^2";
    Random random(7);
    for (const std::string& text : std::vector<std::string>{"x^2+y^2+z^2-1", "x^4+y^4+z^4-5(x^2+y^2+z^2)+11.8",
                                                            "(x^2+9/4y^2+z^2-1)^3-x^2z^3-9/80y^2z^3",
                                                            "(x^2+y^2+z^2+0.75)^2-4(x^2+y^2)", "x^2-y^2z", barth}) {
        Graph graph;
        const Id f = parse(graph, text);
        const Program program = compile(graph, f, kAllOne);
        const RayTracer tracer(program);
        EXPECT_TRUE(tracer.is_polynomial());
        int hits = 0;
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 o = 4.0 * random.direction(), d = glm::normalize(random.vector(1.5) - o);
            const std::vector<Root> a = tracer.hits(o, d, 0, 8, Wanted::All),
                                    b = roots_by_intervals(program, o, d, 0, 8, Wanted::All);
            ASSERT_EQ(a.size(), b.size()) << text << ", ray " << i;
            for (std::size_t k = 0; k < a.size(); ++k) {
                ++hits;
                EXPECT_NEAR(a[k].t, b[k].t, 1e-6) << text;
                const Sample s = sample(program, o + a[k].t * d);
                EXPECT_LE(std::abs(s.value), 1e-11 * (1.0 + glm::length(s.gradient))) << text;
            }
        }
        EXPECT_GT(hits, 20) << text;
    }
}

}  // namespace
}  // namespace normalscope::formulas

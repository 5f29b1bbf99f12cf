#include "core/surface/newton_steps.h"
#include "core/formula/formula.h"
#include "core/program/compile.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace normalscope {
namespace {

// Leaving out points that are done changes nothing: not a bit of where they end, nor of f and ∇f there.
TEST(NewtonSteps, GiveWhatAllStepsOfAllPointsGive) {
    constexpr int kSteps = 8;
    constexpr double kReach = 0.3;
    for (const char* text : {"x^2+y^2+z^2-1", "x^2-y^3", "sin(12x)+cos(12y)-3z", "sqrt(x)+y", "1/x+y", "x^4"}) {
        const formulas::Formula formula = formulas::read(text);
        const formulas::Program program = formulas::compile(formula.graph, formula.f, formulas::Parameters{});
        std::vector<glm::dvec3> points, expected;
        for (int i = 0; i < 1000; ++i)
            points.push_back(0.21 * glm::dvec3(i % 10, i / 10 % 10, i / 100) - glm::dvec3(1.0, 0.93, 0.87));
        for (const glm::dvec3& start : points) {
            glm::dvec3 p = start;
            for (int i = 0; i < kSteps; ++i) {
                const formulas::Sample s = formulas::sample(program, p);
                const glm::dvec3 next = p - s.value / glm::dot(s.gradient, s.gradient) * s.gradient;
                if (glm::length(next - start) <= kReach) p = next;
            }
            expected.push_back(p);
        }
        const std::vector<formulas::Sample> samples = newton_steps(program, points, kSteps, kReach);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double roundings = 32.0 * std::numeric_limits<double>::epsilon() * glm::length(expected[i]);
            EXPECT_LE(glm::distance(points[i], expected[i]), roundings) << text << ", point " << i;
            const formulas::Sample s = formulas::sample(program, points[i]);
            if (std::isnan(s.value)) continue;
            EXPECT_EQ(samples[i].value, s.value) << text;
            if (glm::dot(s.gradient, s.gradient) >= 0.0) {
                EXPECT_EQ(samples[i].gradient, s.gradient) << text;
            }
        }
    }
}

}  // namespace
}  // namespace normalscope

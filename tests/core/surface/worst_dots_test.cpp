#include "core/surface/worst_dots.h"

#include "core/math/normal_rules.h"
#include "random.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace normalscope {
namespace {

std::optional<NormalMap> map_of(const std::optional<glm::dmat3>& matrix) {
    if (!matrix) return std::nullopt;
    return NormalMap{.matrix = glm::dmat4(*matrix)};
}

// The same in so many words, one normal after the other, with tangents found in another way. The largest cosine over
// the plane is the same for any two tangents only if all are looked at: hence the dense fan.
double largest_cosine(const std::vector<glm::dvec3>& normals, const NormalMap& map, const glm::dmat3& tangents) {
    double largest = 0.0;
    for (const glm::dvec3& n : normals) {
        const glm::dvec3 sent = map({n}).xyz;
        if (n == glm::dvec3(0.0) || glm::length(sent) == 0.0) continue;
        const glm::dvec3 u =
            glm::normalize(glm::cross(std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), n));
        const glm::dvec3 v = glm::cross(n, u);
        for (int i = 0; i < 180; ++i) {
            const double a = glm::radians(static_cast<double>(i));
            const glm::dvec3 t = tangents * (std::cos(a) * u + std::sin(a) * v);
            if (glm::length(t) > 0.0)
                largest = std::max(largest, std::abs(glm::dot(glm::normalize(sent), glm::normalize(t))));
        }
    }
    return largest;
}

TEST(WorstDots, AreZeroForTheRightRulesAndBoundedForTheNaive) {
    Random random(31);
    for (int i = 0; i < 300; ++i) {
        glm::dmat3 m3 = random.matrix();
        if (i % 10 == 0) m3[2] = m3[0] + m3[1];
        if (i % 10 == 1) m3 *= 1e90;  // a determinant that doubles just hold
        std::vector<glm::dvec3> normals(2 + static_cast<std::size_t>(random.below(300)));
        for (glm::dvec3& n : normals) n = random.direction();
        normals.front() = {};
        const NormalMatrices matrices = normal_matrices(m3);
        const auto dots = worst_dots(
            normals, {map_of(matrices.naive), map_of(matrices.inverse_transpose), map_of(matrices.cofactor)}, m3);
        EXPECT_EQ(dots[1].has_value(), matrices.inverse_transpose.has_value()) << i;
        const double rounding = 1e-14 * std::pow(matrices.condition().value_or(1e3), 2.0);
        if (dots[1]) {
            EXPECT_LE(*dots[1], rounding) << i;
            EXPECT_LE(*dots[2], rounding) << i;
        }
        // Two tangents of a plane miss its steepest direction by 45° at most.
        const double steepest = largest_cosine(normals, *map_of(matrices.naive), m3);
        EXPECT_LE(*dots[0], steepest + 1e-3) << i;
        if (normals.size() > 200) {
            EXPECT_GE(*dots[0], 0.5 * steepest) << i;
        }
    }
}

TEST(WorstDots, OnSeveralThreadsFindTheOneThatIsWrong) {
    std::vector<glm::dvec3> normals(1'000'003, glm::dvec3(0, 0, 1));
    normals[777'777] = glm::normalize(glm::dvec3(1, 1, 0));
    const glm::dmat3 m3(1, 0, 0, 0, 2, 0, 0, 0, 1);
    const auto dots = worst_dots(normals, {map_of(m3), map_of(glm::inverse(m3)), std::nullopt}, m3);
    EXPECT_GT(*dots[0], 0.6 * std::sqrt(0.5) - 1e-12);  // sin 36.870°, which two tangents miss by 45° at most
    EXPECT_LT(*dots[0], 0.6 + 1e-12);
    EXPECT_NEAR(*dots[1], 0.0, 1e-12);
    EXPECT_FALSE(dots[2]);
}

TEST(WorstDots, WhereThereIsNothingToMeasureThereIsNone) {
    const NormalMap translating{.matrix = glm::translate(glm::dmat4(1.0), {1, 2, 3}), .w = 1.0};
    const ByRule<std::optional<NormalMap>> maps{map_of(glm::dmat3(1.0)), translating, map_of(glm::dmat3(0.0))};
    const auto all_empty = [](const auto& dots) { return !dots[0] && !dots[1] && !dots[2]; };
    EXPECT_TRUE(all_empty(worst_dots(std::vector<glm::dvec3>{}, maps, glm::dmat3(1.0))));
    EXPECT_TRUE(all_empty(worst_dots(std::vector<glm::dvec3>(70, glm::dvec3(0.0)), maps, glm::dmat3(1.0))));
    glm::dmat4 projective(1.0);
    projective[0][3] = 0.25;
    EXPECT_TRUE(all_empty(worst_dots(Mesh{}, maps, Transform<World, Object>(projective))));
    const auto dots = worst_dots(std::vector<glm::dvec3>{{0, 0, 0}, {0, 0, 1}}, maps, glm::dmat3(1.0));
    EXPECT_EQ(dots[0], 0.0);
    EXPECT_GT(*dots[1], 0.4);
    EXPECT_FALSE(dots[2]) << "all normals become zero";
}

}  // namespace
}  // namespace normalscope

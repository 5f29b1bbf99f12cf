#include "core/surface/error_measures.h"

#include "core/math/stack.h"
#include "core/math/transform.h"
#include "core/surface/shapes.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <numeric>

namespace normalscope {
namespace {

TEST(ErrorMeasures, HistogramHoldsEveryNormalOnce) {
    const Mesh sphere = make_shape({.shape = Shape::Sphere});
    const Transform<World, Object> m(glm::dmat4(glm::dmat3(0.5, 0, 0, 0, 2, 0, 0, 0, 1)));
    const auto histogram = error_histogram(sphere, {.matrix = glm::dmat4(m.normal_matrices_by_rule().naive)}, m);
    ASSERT_TRUE(histogram);
    EXPECT_NEAR(std::accumulate(histogram->shares.begin(), histogram->shares.end(), 0.0), 1.0, 1e-12);
    EXPECT_EQ(histogram->most_degrees, 90.0);
    EXPECT_NEAR(histogram->worst_degrees, 61.928, 0.1);
    EXPECT_LT(histogram->mean_degrees, histogram->worst_degrees);
}

TEST(ErrorMeasures, HistogramOfARigidMapIsOneBar) {
    const Mesh cube = make_shape({.shape = Shape::Cube});
    const Transform<World, Object> m(glm::rotate(glm::dmat4(1.0), 1.0, {1.0, 2.0, 3.0}));
    const auto histogram = error_histogram(cube, {.matrix = m.matrix()}, m);
    ASSERT_TRUE(histogram);
    EXPECT_NEAR(histogram->shares.front(), 1.0, 1e-12);
}

TEST(ErrorMeasures, ThereIsNoHistogramWithoutAnInverse) {
    const Transform<World, Object> flat(glm::dmat4(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 0)));
    EXPECT_FALSE(error_histogram(make_shape({}), {.matrix = flat.matrix()}, flat));
}

TEST(ErrorMeasures, AMistakeMayTurnNormalsFartherThanARightAngle) {
    const auto histogram = error_histogram(make_shape({}), {.matrix = glm::dmat4(-1.0)}, Transform<World, Object>());
    ASSERT_TRUE(histogram);
    EXPECT_EQ(histogram->most_degrees, 180.0);
    EXPECT_NEAR(histogram->shares.back(), 1.0, 1e-12);
}

// Whatever M is: askew, mirrored, rigid, or without an inverse.
TEST(ErrorMeasures, MeasuredPointsMeetTheClosedForm) {
    const glm::dmat3 askew =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, {1.0, 2.0, 3.0})) * glm::dmat3(1, 0, 0, 0.8, 1, 0, 0, 0.3, -2);
    for (const glm::dmat3& m3 :
         {askew, glm::dmat3(1.0), glm::dmat3(0.5, 0, 0, 0, 2, 0, 0, 0, 1), glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 0),
          glm::dmat3(0.0), glm::dmat3(1e-8, 0, 0, 0, 1, 0, 0, 0, 1e8)})
        for (const MeasuredError& measured : measured_errors(m3)) {
            EXPECT_LE(measured.degrees, error_bound_degrees(measured.k) + 1e-6) << measured.k;
            EXPECT_NEAR(measured.degrees, error_bound_degrees(measured.k), 1.0) << measured.k;
        }
}

TEST(ErrorStatistics, TheMeanIsByAreaHoweverTheMeshIsCut) {
    // A unit square, z = 0, and beside it another that leans, cut into strips.
    const auto wedge = [](int strips) {
        Mesh mesh;
        const auto add = [&](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
            for (const glm::dvec3& p : {a, b, c, d}) {
                mesh.positions.push_back(p);
                mesh.normals.push_back(n);
            }
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            mesh.triangles.emplace_back(first, first + 2, first + 3);
        };
        add({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
        for (int i = 0; i < strips; ++i) {
            const double y = 1.0 + static_cast<double>(i) / strips, z = y - 1.0, step = 1.0 / strips;
            add({0, y, z}, {1, y, z}, {1, y + step, z + step}, {0, y + step, z + step});
        }
        return mesh;
    };
    const Transform<World, Object> m(matrix(Scale{{1, 2, 1}}));
    const double error = *error_degrees(m.normal_matrices_by_rule(), {{0, -1, 1}}), root = std::sqrt(2.0);
    for (const int strips : {1, 7, 50}) {
        const Mesh mesh = wedge(strips);
        EXPECT_NEAR(error_statistics(mesh, m.normal_matrices_by_rule())->mean_degrees, error * root / (1.0 + root),
                    1e-9);
        EXPECT_NEAR(error_histogram(mesh, {.matrix = m.matrix()}, m)->mean_degrees, error * root / (1.0 + root), 1e-9);
    }
}

}  // namespace
}  // namespace normalscope

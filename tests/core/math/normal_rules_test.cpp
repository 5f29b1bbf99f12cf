#include "core/math/normal_rules.h"

#include "core/math/stack.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace normalscope {
namespace {

NormalMatrices scaled(double x, double y, double z) { return normal_matrices(glm::dmat3(matrix(Scale{{x, y, z}}))); }

TEST(NormalRules, WorstErrorsOfTheLecture) {
    EXPECT_NEAR(*scaled(1, 2, 1).error_bound_degrees(), 36.870, 5e-4);
    EXPECT_NEAR(*scaled(0.5, 2, 1).error_bound_degrees(), 61.928, 5e-4);
    // Attained halfway between the axes of the extreme stretches.
    EXPECT_NEAR(*error_degrees(scaled(0.5, 2, 1), {{1, 1, 0}}), 61.928, 5e-4);
    EXPECT_NEAR(*error_degrees(scaled(1, 2, 1), {{1, 1, 0}}), 36.870, 5e-4);
}

TEST(NormalRules, ScaleStretchesNormalsTheOppositeWay) {
    const NormalMatrices m = scaled(0.5, 2, 1);
    EXPECT_EQ(*m.inverse_transpose, glm::dmat3(matrix(Scale{{2, 0.5, 1}})));
    EXPECT_EQ(m.cofactor, glm::dmat3(matrix(Scale{{2, 0.5, 1}})));
    EXPECT_EQ(m.determinant, 1.0);
    EXPECT_EQ(m.sigma, glm::dvec3(2, 1, 0.5));
    EXPECT_EQ(*m.condition(), 4.0);
    EXPECT_EQ(m.rank, 3);
}

TEST(NormalRules, NaiveIsRightForRigidAndUniformMaps) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(1, 2, 3));
    for (const StackEntry& entry : {StackEntry{Rotate{{1, 2, 3}, 77}}, StackEntry{Translate{{5, 6, 7}}},
                                    StackEntry{Scale{glm::dvec3(3)}}, StackEntry{Scale{{1, 1, -1}}}})
        EXPECT_NEAR(*error_degrees(normal_matrices(glm::dmat3(matrix(entry))), {n}), 0.0, 1e-13) << name(entry);
    EXPECT_NEAR(*scaled(-3, 3, 3).error_bound_degrees(), 0.0, 1e-13);
}

TEST(NormalRules, ReflectionPartsTheConventions) {
    const Transform<World, Object> mirror(matrix(Scale{{-1, 1, 1}}));
    const Normal<Object> n{{0.6, 0.8, 0}};
    EXPECT_EQ(mirror(n)->xyz, glm::dvec3(-0.6, 0.8, 0));                               // stays outside
    EXPECT_EQ(transform_normal_by_cofactor(mirror, n).xyz, glm::dvec3(0.6, -0.8, 0));  // follows the winding
    EXPECT_EQ(mirror.normal_matrices_by_rule().determinant, -1.0);
}

TEST(NormalRules, FlattenedObjectsKeepTheCofactorNormal) {
    const NormalMatrices flat = scaled(1, 0, 1);
    EXPECT_EQ(flat.rank, 2);
    EXPECT_EQ(flat.determinant, 0.0);
    EXPECT_FALSE(flat.inverse_transpose);
    EXPECT_FALSE(flat.condition());
    EXPECT_FALSE(flat.error_bound_degrees());
    EXPECT_FALSE(flat.by(Rule::InverseTranspose));
    EXPECT_EQ(flat.cofactor * glm::dvec3(0.6, 0.8, 0), glm::dvec3(0, 0.8, 0));

    for (const NormalMatrices& m : {scaled(0, 0, 1), scaled(0, 0, 0)}) {
        EXPECT_LT(m.rank, 2);
        EXPECT_EQ(m.cofactor, glm::dmat3(0.0));
    }
    EXPECT_EQ(scaled(0, 0, 1).rank, 1);
    EXPECT_EQ(scaled(0, 0, 0).rank, 0);
}

TEST(NormalRules, TinyAndHugeScalesStayFinite) {
    for (const double s : {1e-160, 1e-91, 1e-89, 1e-60, 1e-8, 1e8, 1e50}) {
        const NormalMatrices m = scaled(s, 2 * s, s);
        EXPECT_EQ(m.rank == 3, m.inverse_transpose.has_value()) << s;
        EXPECT_EQ(m.rank == 3, m.determinant != 0.0) << s;
        if (!m.inverse_transpose) continue;
        EXPECT_NEAR(*error_degrees(m, {{1, 1, 0}}), 36.870, 5e-4) << s;
        EXPECT_NEAR((*m.inverse_transpose)[0][0] * s, 1.0, 1e-14) << s;
    }
}

TEST(NormalRules, RoundingDoesNotMakeAFlatObjectInvertible) {
    Scene scene;
    scene.stack = {Scale{{1e6, 1, 1}},    Rotate{{1, 2, 3}, 40}, Scale{{1, 0, 1}},
                   Rotate{{3, 1, 2}, 70}, Scale{{1e-6, 1, 1}},   Rotate{{1, 1, 0}, 20}};
    EXPECT_EQ(world_from_object(scene).normal_matrices_by_rule().rank, 2);
    EXPECT_FALSE(world_from_object(scene)(Normal<Object>{{1, 0, 0}}));
}

TEST(NormalRules, WhatIsInvertibleStaysSoHoweverUnevenlyItStretches) {
    const auto of = [](std::vector<StackEntry> stack) {
        Scene scene;
        scene.stack = std::move(stack);
        return world_from_object(scene).normal_matrices_by_rule();
    };
    const NormalMatrices uneven = of({Scale{{1e8, 1e-8, 1}}});
    EXPECT_EQ(uneven.rank, 3);
    EXPECT_NEAR(uneven.determinant, 1.0, 1e-15);
    EXPECT_NEAR(*uneven.condition() / 1e16, 1.0, 1e-12);
    EXPECT_NEAR((*uneven.inverse_transpose)[1].y / 1e8, 1.0, 1e-15);
    const NormalMatrices back = of({Scale{{1e8, 1e-8, 1}}, Scale{{1e-8, 1e8, 1}}});
    EXPECT_EQ(back.rank, 3);
    EXPECT_NEAR(back.determinant, 1.0, 1e-15);
    const NormalMatrices shear = of({Shear{.xy = 1e9}});
    EXPECT_EQ(shear.rank, 3);
    EXPECT_EQ(shear.determinant, 1.0);
    EXPECT_NEAR(shear.sigma.z * 1e9, 1.0, 1e-6);
    EXPECT_EQ(of({Shear{.xy = 1e9}, Shear{.xy = -1e9}}).rank, 3);
    // Shears that undo each other's effect, entries that are noise, and products that rounding leaves without digits are none.
    EXPECT_EQ(of({Shear{.xy = 1, .yx = 1}}).rank, 2);
    EXPECT_EQ(of({Matrix{glm::dmat4(glm::dmat3(1, 0, 0, 0, 6e-17, 0, 0, 0, 1))}}).rank, 2);
    EXPECT_EQ(of({Rotate{{1, 2, 3}, 40}, Scale{{1e12, 1, 1e-12}}, Rotate{{3, 1, 2}, 70}}).rank, 2);
}

TEST(NormalRules, AnglesAreAccurateAtBothEnds) {
    for (const double degrees : {0.0, 1e-9, 1e-3, 45.0, 90.0, 179.999, 180.0}) {
        const double a = degrees * std::acos(-1.0) / 180.0;
        EXPECT_NEAR(*angle_degrees({3, 0, 0}, 1e-5 * glm::dvec3(std::cos(a), std::sin(a), 0)), degrees,
                    1e-13 + 1e-15 * degrees * 180);
    }
    EXPECT_FALSE(angle_degrees({0, 0, 0}, {1, 0, 0}));
}

TEST(Stack, FirstEntryActsFirst) {
    const std::vector<StackEntry> stack{Scale{{2, 1, 1}}, Rotate{{0, 0, 1}, 90}, Translate{{0, 0, 5}}};
    const Transform<World, Object> m(product(stack));
    EXPECT_EQ(m(Point<Object>{{1, 0, 0}}).xyz, glm::dvec3(0, 2, 5));
    EXPECT_EQ(m(Vector<Object>{{1, 0, 0}}).xyz, glm::dvec3(0, 2, 0));
}

TEST(Stack, QuarterTurnsAreExact) {
    EXPECT_EQ(matrix(Rotate{{0, 0, 7}, 450}), matrix(Rotate{{0, 0, 1}, 90}));
    EXPECT_EQ(matrix(Rotate{{0, 0, 1}, 90})[0], glm::dvec4(0, 1, 0, 0));
    EXPECT_EQ(matrix(Rotate{{0, 1, 0}, -180})[0], glm::dvec4(-1, 0, 0, 0));
}

TEST(Stack, ShearSlidesCoordinates) {
    const glm::dmat4 m = matrix(Shear{.xy = 2, .yz = 3, .zx = 5});
    EXPECT_EQ(m * glm::dvec4(0, 1, 0, 1), glm::dvec4(2, 1, 0, 1));
    EXPECT_EQ(m * glm::dvec4(0, 0, 1, 1), glm::dvec4(0, 3, 1, 1));
    EXPECT_EQ(m * glm::dvec4(1, 0, 0, 1), glm::dvec4(1, 0, 5, 1));
}

TEST(Transform, InverseKeepsTheDigitsThatTheConditionLeaves) {
    for (const double k : {1e2, 1e4, 1e6}) {
        const glm::dmat4 m = product(std::vector<StackEntry>{Rotate{{1, 2, 3}, 33}, Scale{{k, 1, 1 / k}},
                                                             Rotate{{3, -1, 2}, 71}, Translate{{4, 5, 6}}});
        const glm::dmat4 round = m * Transform<World, Object>(m).inverse()->matrix();
        for (int c = 0; c < 4; ++c) EXPECT_LT(glm::length(round[c] - glm::dmat4(1.0)[c]), 1e-14 * k * k) << k;
    }
}

TEST(Transform, InverseGoesBack) {
    const Transform<World, Object> m(
        product(std::vector<StackEntry>{Scale{{2, -1, 0.5}}, Rotate{{1, 2, 3}, 33}, Translate{{4, 5, 6}}}));
    const Point<Object> p{{0.1, 0.2, 0.3}};
    EXPECT_LT(glm::length((*m.inverse())(m(p)).xyz - p.xyz), 1e-14);
    const Transform<Object, Object> round_trip = *m.inverse() * m;
    EXPECT_LT(glm::length(round_trip(p).xyz - p.xyz), 1e-14);
}

}  // namespace
}  // namespace normalscope

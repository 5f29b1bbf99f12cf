#include "core/math/sheets.h"

#include "random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace normalscope {
namespace {

Transform<World, Object> any_with_inverse(Random& random) {
    for (;;) {
        glm::dmat4 m(random.matrix(3.0));
        m[3] = glm::dvec4(random.vector(10.0), 1.0);
        const Transform<World, Object> t(m);
        if (t.rank() == 3 && *t.normal_matrices_by_rule().condition() < 1e3) return t;
    }
}

TEST(Sheets, AStepAlongAnAxisCrossesAsManyAsTheNormalsNumberSays) {
    const Normal<Object> n{{0.6, 0.8, -0.3}};
    EXPECT_DOUBLE_EQ(sheets_crossed(n, Vector<Object>{{2.0, 0, 0}}, 2.0), 0.6);
    EXPECT_DOUBLE_EQ(sheets_crossed(n, Vector<Object>{{0, 0.1, 0}}, 0.1), 0.8);
    EXPECT_DOUBLE_EQ(sheets_crossed(n, Vector<Object>{{0, 0, 1}}, 1.0), -0.3);
    // Halve x, and a step along x crosses twice as many; double y, and one along y crosses half as many.
    const Transform<World, Object> m(matrix(Scale{{0.5, 2, 1}}));
    EXPECT_DOUBLE_EQ(sheets_crossed(*m(n), Vector<World>{{1, 0, 0}}, 1.0), 1.2);
    EXPECT_DOUBLE_EQ(sheets_crossed(*m(n), Vector<World>{{0, 1, 0}}, 1.0), 0.4);
}

TEST(Sheets, WhatIsCarriedAlongCrossesAsManyAsBefore) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const Transform<World, Object> m = any_with_inverse(random);
        const Normal<Object> n{random.direction()};
        const Vector<Object> step{random.vector(2.0)};
        const Vector<Object> tangent{glm::cross(n.xyz, random.direction())};
        EXPECT_NEAR(sheets_crossed(*m(n), m(step), 0.3), sheets_crossed(n, step, 0.3), 1e-10);
        EXPECT_NEAR(sheets_crossed(*m(n), m(tangent), 0.3), 0.0, 1e-10);
    }
}

// Counted at the carried sheets themselves, without a normal: where a step goes through each plane of image points.
TEST(Sheets, TheNumberIsCountedAtTheCarriedSheets) {
    Random random(2);
    for (int i = 0; i < 300; ++i) {
        const Transform<World, Object> m = any_with_inverse(random);
        const glm::dvec3 n = random.direction(), u = glm::normalize(glm::cross(n, random.direction())),
                         v = glm::cross(n, u);
        const double spacing = 0.1;
        const Point<World> from = m(Point<Object>{});
        const Vector<World> step{random.vector(1.0)};
        const double said = sheets_crossed(*m(Normal<Object>{n}), step, spacing);
        int counted = 0;
        for (int k = -20000; k <= 20000 && std::abs(said) < 20000; ++k) {
            if (k == 0) continue;
            // From + t step in the plane through the image of k d n, along those of u and v.
            const glm::dvec3 at = m(Point<Object>{k * spacing * n}).xyz - from.xyz;
            const glm::dvec3 across = glm::cross(m(Vector<Object>{u}).xyz, m(Vector<Object>{v}).xyz);
            const double t = glm::dot(at, across) / glm::dot(step.xyz, across);
            if (t > 0.0 && t <= 1.0) ++counted;
        }
        if (std::abs(said - std::round(said)) > 1e-6 && std::abs(said) < 20000) {
            EXPECT_EQ(counted, static_cast<int>(std::floor(std::abs(said)))) << said;
        }
    }
}

}  // namespace
}  // namespace normalscope

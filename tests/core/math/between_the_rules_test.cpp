// The way from the naive rule to the inverse transpose: U Σᵖ Vᵀ.

#include "core/math/polar_decomposition.h"
#include "random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace normalscope {
namespace {

double distance(const glm::dmat3& a, const glm::dmat3& b) { return largest_entry(a - b) / largest_entry(b); }

// Any M3 that can be told from a singular one, every other of them a reflection.
NormalMatrices any_with_inverse(Random& random) {
    for (;;) {
        const NormalMatrices m = normal_matrices(random.matrix(3.0));
        if (m.rank == 3 && *m.condition() < 1e3) return m;
    }
}

TEST(BetweenTheRules, BeginsAtTheOneAndEndsAtTheOther) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const NormalMatrices m = any_with_inverse(random);
        EXPECT_EQ(*between_the_rules(m, 1.0), m.naive);
        EXPECT_EQ(*between_the_rules(m, -1.0), *m.inverse_transpose);
        EXPECT_LT(distance(*between_the_rules(m, 1.0 - 1e-12), m.naive), 1e-9);
        EXPECT_LT(distance(*between_the_rules(m, 1e-12 - 1.0), *m.inverse_transpose), 1e-9);
        const glm::dmat3 rotation = *between_the_rules(m, 0.0);
        EXPECT_LT(distance(glm::transpose(rotation) * rotation, glm::dmat3(1.0)), 1e-12);
        EXPECT_LT(distance(rotation, decomposition(m.naive).rotation), 1e-12);
    }
}

// (N_p)ᵀ N_−p = 1: each is the inverse transpose of the other.
TEST(BetweenTheRules, OppositePowersUndoEachOther) {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const NormalMatrices m = any_with_inverse(random);
        const double p = random.uniform(-1.0, 1.0);
        const glm::dmat3 one = glm::transpose(*between_the_rules(m, p)) * *between_the_rules(m, -p);
        EXPECT_LT(distance(one, glm::dmat3(1.0)), 1e-9) << p;
    }
}

TEST(BetweenTheRules, TheClosedFormIsTheLargestErrorAndIsAttained) {
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const NormalMatrices m = any_with_inverse(random);
        const double p = random.uniform(-1.0, 1.0), k = *m.condition(), bound = *m.error_bound_degrees(p);
        EXPECT_NEAR(bound,
                    glm::degrees(std::atan(std::pow(k, (p + 1.0) / 2.0)) - std::atan(std::pow(k, -(p + 1.0) / 2.0))),
                    1e-9);
        const glm::dmat3 bent = *between_the_rules(m, p);
        for (int j = 0; j < 20; ++j) {
            const glm::dvec3 n = random.direction();
            EXPECT_LE(*angle_degrees(bent * n, *m.inverse_transpose * n), bound + 1e-7);
        }
        const auto worst = worst_normal(m, p);
        ASSERT_TRUE(worst);
        for (std::size_t side = 0; side < 2; ++side) {
            const glm::dvec3 n = worst->object[side].xyz;
            EXPECT_NEAR(*angle_degrees(bent * n, *m.inverse_transpose * n), bound, 1e-7) << p;
            EXPECT_LT(*angle_degrees(bent * n, worst->naive[side].xyz), 1e-7) << p;
            EXPECT_LT(*angle_degrees(*m.inverse_transpose * n, worst->right[side].xyz), 1e-7) << p;
        }
    }
}

// Whenever n·t = 0, then N n · M t = 0: of no power but −1, unless M stretches evenly.
TEST(BetweenTheRules, NoPowerButTheLastIsRightForEveryNormal) {
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        const NormalMatrices m = any_with_inverse(random);
        if (*m.condition() < 1.05) continue;
        const auto most_off = [&](double p) {
            const glm::dmat3 bent = *between_the_rules(m, p);
            double most = 0.0;
            for (int j = 0; j < 60; ++j) {
                const glm::dvec3 n = random.direction(), t = glm::normalize(glm::cross(n, random.direction()));
                most = std::max(most, std::abs(glm::dot(glm::normalize(bent * n), glm::normalize(m.naive * t))));
            }
            return most;
        };
        EXPECT_LT(most_off(-1.0), 1e-11);
        for (const double p : {1.0, 0.5, 0.0, -0.5, random.uniform(-0.9, 1.0)}) EXPECT_GT(most_off(p), 1e-4) << p;
        EXPECT_EQ(*m.error_bound_degrees(-1.0), 0.0);
        EXPECT_GT(*m.error_bound_degrees(-0.99), 0.0);
    }
    const NormalMatrices even = normal_matrices(glm::dmat3(-3.0));
    for (const double p : {1.0, 0.3, -0.7, -1.0}) EXPECT_LT(*even.error_bound_degrees(p), 1e-12);
}

TEST(BetweenTheRules, AReflectionStaysOneAndTheNormalStaysOutside) {
    Random random(5);
    int reflections = 0;
    for (int i = 0; i < 200; ++i) {
        const NormalMatrices m = any_with_inverse(random);
        if (m.determinant < 0.0) ++reflections;
        const glm::dmat3 bent = *between_the_rules(m, random.uniform(-1.0, 1.0));
        EXPECT_EQ(glm::determinant(bent) < 0.0, m.determinant < 0.0);
        const glm::dvec3 n = random.direction();
        EXPECT_GT(glm::dot(bent * n, *m.inverse_transpose * n), 0.0);
    }
    EXPECT_GT(reflections, 50);
}

TEST(BetweenTheRules, WithoutAnInverseTheWayEndsAtTheRotation) {
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const int rank = i % 3;
        glm::dmat3 m3(0.0);
        for (int k = 0; k < rank; ++k) m3 += glm::outerProduct(random.vector(2.0), random.vector(2.0));
        const NormalMatrices m = normal_matrices(m3, rank);
        for (const double p : {-1e-9, -0.5, -1.0}) EXPECT_FALSE(between_the_rules(m, p)) << rank;
        EXPECT_FALSE(worst_normal(m, 0.5));
        EXPECT_EQ(*between_the_rules(m, 1.0), m3);
        const glm::dmat3 still = *between_the_rules(m, 0.0);
        EXPECT_LT(largest_entry(still - *between_the_rules(m, 1e-12)), 1e-9);
        // What M throws away stays thrown away; what it keeps is only turned.
        EXPECT_LT(largest_entry(still * glm::transpose(still) * still - still), 1e-9);
    }
}

}  // namespace
}  // namespace normalscope

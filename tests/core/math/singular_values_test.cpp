#include "random.h"

#include "core/math/normal_rules.h"

#include <gtest/gtest.h>

#if __has_include(<Eigen/SVD>)
#include <Eigen/SVD>
#endif

namespace normalscope {
namespace {

// General ones, and those that break careless implementations: of every rank, ill-conditioned, tiny, huge, orthogonal.
glm::dmat3 difficult_matrix(Random& random) {
    glm::dmat3 m = random.matrix();
    switch (random.below(8)) {
        case 0: m[2] = m[0] + m[1]; break;                            // rank 2
        case 1: m = glm::outerProduct(m[0], m[1]); break;             // rank 1
        case 2: m = glm::dmat3(glm::normalize(m[0]), {}, {}); break;  // zero columns
        case 3: m[1] *= 1e-9, m[2] *= 1e-14; break;                   // ill-conditioned
        case 4: m *= 1e-40; break;
        case 5: m *= 1e40; break;
        case 6:
            m = glm::dmat3(matrix(StackEntry{Rotate{random.direction(), random.uniform(0, 360)}}));
            break;  // σ all 1
        default: break;
    }
    return m;
}

TEST(SingularValues, DecomposeAnyMatrix) {
    Random random(11);
    for (int i = 0; i < 100'000 && !HasFailure(); ++i) {
        const glm::dmat3 a = difficult_matrix(random);
        const SingularValues s = singular_values(a);
        const glm::dmat3 sigma(s.sigma.x, 0, 0, 0, s.sigma.y, 0, 0, 0, s.sigma.z);
        EXPECT_GE(s.sigma.x, s.sigma.y);
        EXPECT_GE(s.sigma.y, s.sigma.z);
        EXPECT_GE(s.sigma.z, 0.0);
        EXPECT_LE(norm(s.u * sigma * glm::transpose(s.v) - a), 1e-14 * norm(a));
        EXPECT_LE(norm(s.v * glm::transpose(s.v) - glm::dmat3(1.0)), 1e-14);
        if (s.sigma.z > 1e-8 * s.sigma.x) {
            EXPECT_LE(norm(s.u * glm::transpose(s.u) - glm::dmat3(1.0)), 1e-7);
        }
    }
}

#if __has_include(<Eigen/SVD>)
TEST(SingularValues, AgreeWithEigen) {
    Random random(12);
    for (int i = 0; i < 100'000 && !HasFailure(); ++i) {
        const glm::dmat3 a = difficult_matrix(random);
        Eigen::Matrix3d e;
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) e(r, c) = a[c][r];
        const Eigen::Vector3d expected = Eigen::JacobiSVD<Eigen::Matrix3d>(e).singularValues();
        const glm::dvec3 sigma = singular_values(a).sigma;
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(sigma[k], expected(k), 1e-14 * expected(0));
    }
}
#endif

}  // namespace
}  // namespace normalscope

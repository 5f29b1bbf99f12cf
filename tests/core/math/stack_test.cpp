// What the program teaches, over 10⁵ random stacks: rotations, shears, scales (negative and zero ones too), any matrix.

#include "random.h"

#include "core/surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace normalscope {
namespace {

constexpr int kStacks = 100'000;

struct Case {
    std::vector<StackEntry> stack;
    Transform<World, Object> world_from_object;
    glm::dmat3 m3;
    /// Rounding errors in the cofactors, relative to the cofactors that matter least: at least the condition number.
    double amplification;
    bool singular_entry = false;
};

template <class Check>
void for_random_stacks(std::uint64_t seed, Check&& check) {
    Random random(seed);
    for (int i = 0; i < kStacks && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE("stack " + std::to_string(i));
        Scene scene;
        scene.stack = random.stack(6);
        Case c{scene.stack, world_from_object(scene), {}, 0.0};
        c.m3 = glm::dmat3(c.world_from_object.matrix());
        const NormalMatrices& matrices = c.world_from_object.normal_matrices_by_rule();
        c.amplification = matrices.rank == 3 ? std::pow(norm(c.m3), 3.0) / std::abs(matrices.determinant) : INFINITY;
        for (const StackEntry& entry : c.stack)
            c.singular_entry = c.singular_entry || normal_matrices(glm::dmat3(matrix(entry))).rank < 3;
        check(c, random);
    }
}

TEST(Stack, NormalsStayPerpendicularToTangents) {
    int inverse_transposes = 0, cofactors_of_flattened = 0;
    for_random_stacks(1, [&](const Case& c, Random& random) {
        const Normal<Object> n{random.direction()};
        const Vector<Object> t{glm::normalize(glm::cross(n.xyz, random.direction()))};
        const Vector<World> tangent = c.world_from_object(t);

        // The cofactor rule for every M whatsoever. Its entries are right to ε‖M‖², however small they are.
        const Normal<World> cofactor = transform_normal_by_cofactor(c.world_from_object, n);
        EXPECT_LE(std::abs(dot(cofactor, tangent)), 1e-14 * std::pow(norm(c.m3), 3.0));
        cofactors_of_flattened += c.world_from_object.normal_matrices_by_rule().rank == 2 ? 1 : 0;

        if (const std::optional<Normal<World>> normal = c.world_from_object(n)) {
            ++inverse_transposes;
            const double size = glm::length(normal->xyz) * glm::length(tangent.xyz);
            EXPECT_LE(std::abs(dot(*normal, tangent)), 1e-14 * c.amplification * std::max(size, 1.0));
            if (c.amplification < 1e3) {
                EXPECT_LE(std::abs(dot(*normal, tangent)), 1e-11 * size);
            }
        }
    });
    EXPECT_GT(inverse_transposes, kStacks / 2);
    EXPECT_GT(cofactors_of_flattened, kStacks / 100);
}

TEST(Stack, SingularEntriesMakeItSingular) {
    int singular = 0;
    for_random_stacks(2, [&](const Case& c, Random&) {
        const NormalMatrices& m = c.world_from_object.normal_matrices_by_rule();
        EXPECT_EQ(m.rank == 3, m.inverse_transpose.has_value());
        EXPECT_EQ(m.rank == 3, m.determinant != 0.0);
        EXPECT_EQ(m.rank == 3, m.error_bound_degrees().has_value());
        if (!c.singular_entry) return;
        ++singular;
        EXPECT_LT(m.rank, 3);
        EXPECT_EQ(m.sigma.z, 0.0);
        EXPECT_FALSE(composite_of_inverse_transposes(c.stack));
        EXPECT_FALSE(c.world_from_object.inverse());
    });
    EXPECT_GT(singular, kStacks / 50);
}

TEST(Stack, CompositeOfInversesIsInverseOfComposite) {
    int compared = 0;
    for_random_stacks(3, [&](const Case& c, Random&) {
        const auto composite = composite_of_inverse_transposes(c.stack);
        const auto& direct = c.world_from_object.normal_matrices_by_rule().inverse_transpose;
        if (!composite || !direct) return;
        double error = 1e-14;  // each entry's inverse loses digits of its own
        for (const StackEntry& entry : c.stack) error *= 3.0 * *normal_matrices(glm::dmat3(matrix(entry))).condition();
        error = std::max(error, 1e-14 * c.amplification);
        if (error > 1e-3) return;
        ++compared;
        EXPECT_LE(norm(*composite - *direct), error * norm(*direct));
    });
    EXPECT_GT(compared, kStacks / 2);
}

TEST(Stack, CofactorIsDeterminantTimesInverseTranspose) {
    for_random_stacks(4, [&](const Case& c, Random&) {
        const NormalMatrices& m = c.world_from_object.normal_matrices_by_rule();
        // cof(M)ᵀ M = det(M) I, for singular M too.
        const glm::dmat3 product = glm::transpose(m.cofactor) * c.m3;
        EXPECT_LE(norm(product - m.determinant * glm::dmat3(1.0)), 1e-14 * std::pow(norm(c.m3), 3.0));
        if (m.inverse_transpose && c.amplification < 1e6) {
            EXPECT_LE(norm(glm::transpose(*m.inverse_transpose) * c.m3 - glm::dmat3(1.0)), 1e-14 * c.amplification);
        }
    });
}

TEST(Stack, NaiveErrorHasItsClosedForm) {
    int compared = 0;
    double largest_share = 0.0;
    for_random_stacks(5, [&](const Case& c, Random& random) {
        const NormalMatrices& m = c.world_from_object.normal_matrices_by_rule();
        if (!m.inverse_transpose || c.amplification > 1e6) return;
        ++compared;
        const double bound = *m.error_bound_degrees(), slack = 1e-11 * c.amplification;
        const double k = m.sigma.x / m.sigma.z;
        EXPECT_NEAR(std::cos(bound * std::acos(-1.0) / 180.0), 2.0 / (k + 1.0 / k), 1e-12);

        // (M n)·((M⁻¹)ᵀ n) = n·n: the two are never 90° apart.
        const Normal<Object> n{random.uniform(0.1, 10.0) * random.direction()};
        const double product =
            glm::dot(transform_normal_naively(c.world_from_object, n).xyz, c.world_from_object(n)->xyz);
        EXPECT_NEAR(product / glm::dot(n.xyz, n.xyz), 1.0, 1e-13 * c.amplification);

        const double error = *error_degrees(m, n);
        EXPECT_LE(error, bound + slack);
        if (bound > 1.0) largest_share = std::max(largest_share, error / bound);

        // With n = V y, cos = y·y / (|Σ y| |Σ⁻¹ y|): least for y = (1, 0, 1), halfway between the extreme stretch axes.
        const SingularValues svd = singular_values(c.m3);
        for (const double sign : {-1.0, 1.0})
            EXPECT_NEAR(*error_degrees(m, {svd.v[0] + sign * svd.v[2]}), bound, slack);
    });
    EXPECT_GT(compared, kStacks / 2);
    EXPECT_GT(largest_share, 0.99);
}

TEST(Stack, StatisticsAreThoseOfThePoints) {
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        const NormalMatrices m = normal_matrices(random.matrix());
        if (!m.inverse_transpose) continue;
        Mesh mesh;
        double worst = 0.0, sum = 0.0;
        for (int k = 0; k < 50; ++k) {
            mesh.positions.push_back(random.vector());
            mesh.normals.push_back(random.direction());
            worst = std::max(worst, *error_degrees(m, {mesh.normals.back()}));
            sum += *error_degrees(m, {mesh.normals.back()});
        }
        mesh.positions.emplace_back(0.0);
        mesh.normals.emplace_back(0.0);  // a vertex without a normal does not count
        const auto statistics = error_statistics(mesh, m);
        ASSERT_TRUE(statistics);
        EXPECT_NEAR(statistics->worst_degrees, worst, 1e-9);
        EXPECT_NEAR(statistics->mean_degrees, sum / 50.0, 1e-9);
        const auto at = std::ranges::find(mesh.positions, statistics->at.xyz) - mesh.positions.begin();
        EXPECT_NEAR(*error_degrees(m, {mesh.normals[static_cast<std::size_t>(at)]}), worst, 1e-9);
    }
}

}  // namespace
}  // namespace normalscope

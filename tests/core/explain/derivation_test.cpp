// What `normalscope explain` says, against Eigen in long double and against itself, at random stacks: rank-deficient,
// reflected, badly scaled.

#include "core/picture/make_frame.h"
#include "random.h"

#include "core/explain/explanation.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <regex>

#if __has_include(<Eigen/Dense>)
#include <Eigen/Dense>
#endif

namespace normalscope {
namespace {

using Json = nlohmann::json;

std::vector<StackEntry> any_stack(Random& random) {
    std::vector<StackEntry> stack = random.stack(6);
    if (random.chance(0.3)) {  // badly scaled, and turned so that the axes do not show it
        const auto factor = [&] { return std::pow(10.0, random.uniform(-8.0, 8.0)); };
        stack.emplace_back(Rotate{random.direction(), random.uniform(-180.0, 180.0)});
        stack.emplace_back(Scale{{factor(), factor(), factor()}});
    }
    if (random.chance(0.2)) stack.emplace_back(Scale{{1.0, -1.0, 1.0}});
    if (random.chance(0.1)) {  // of rank 2 or 1, without a zero to be seen
        const glm::dvec3 a = random.vector(), b = random.vector();
        glm::dmat4 m(random.chance(0.5)
                         ? glm::outerProduct(a, b)
                         : glm::outerProduct(a, b) + glm::outerProduct(random.vector(), random.vector()));
        m[3].w = 1.0;
        stack.emplace_back(Matrix{m});
    }
    return stack;
}

Probe any_probe(Random& random) {
    const glm::dvec3 n = random.direction(), t = glm::normalize(glm::cross(n, random.direction()));
    return {{random.vector()}, {n}, {Vector<Object>{t}, Vector<Object>{glm::cross(n, t)}}};
}

template <class Check>
void for_random_explanations(std::uint64_t seed, int count, Check&& check) {
    Random random(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE("scene " + std::to_string(i));
        Scene scene;
        scene.stack = any_stack(random);
        check(scene, explanation(scene, any_probe(random), static_cast<std::size_t>(i % 2)));
    }
}

TEST(Derivation, EveryLineIsWhatItClaims) {
    int ranks[4] = {}, reflections = 0, ill_conditioned = 0;
    for_random_explanations(11, 20'000, [&](const Scene&, const Explanation& e) {
        const int rank = e.matrices.rank;
        ++ranks[rank];
        reflections += e.matrices.determinant < 0.0 ? 1 : 0;
        ill_conditioned += e.claims.condition.value_or(0.0) > 1e6 ? 1 : 0;
        for (const Step& step : e.derivation.steps) {
            SCOPED_TRACE(step.id + ", rank " + std::to_string(rank));
            const bool has_normal = e.derivation.n_world_by.has_value();
            const bool needs_inverse = step.id == "solved" || step.id == "rule";
            const auto expected = step.id != "given" && !has_normal         ? Step::State::NoValue
                                  : needs_inverse && rank < 3               ? Step::State::NoValue
                                  : step.id == "same-direction" && rank < 3 ? Step::State::Fails
                                                                            : Step::State::Holds;
            EXPECT_EQ(name(step.state), name(expected)) << expression_text(step.line);
            // The figure to reach, for condition numbers up to 1e6: reached for every condition number, since the cofactors
            // are right to the last digit. It is relative to the terms that the sums are made of.
            if (step.state == Step::State::Holds) {
                EXPECT_LE(step.residual->relative, 1e-12)
                    << expression_text(step.line) << ", condition " << e.claims.condition.value_or(0.0);
            }
        }
        if (rank == 3) {
            EXPECT_EQ(e.derivation.n_world_by, Rule::InverseTranspose);
            for (const RuleCheck& check : e.derivation.checks) {
                ASSERT_TRUE(check.degrees_off.has_value());
                EXPECT_LE(*check.degrees_off, check.rule == Rule::Naive ? *e.claims.worst_degrees + 1e-6 : 1e-6)
                    << name(check.rule);
                if (check.rule == Rule::Naive) continue;
                for (const auto& d : check.dots) EXPECT_LE(std::abs((*d)(0, 0)), d->error[0]);
            }
        }
    });
    EXPECT_GT(ranks[1], 100);
    EXPECT_GT(ranks[2], 100);
    EXPECT_GT(reflections, 1000);
    EXPECT_GT(ill_conditioned, 1000);
}

TEST(Derivation, DotProductsAreWrittenOut) {
    const Transform<World, Object> m(matrix(Scale{{0.5, 2, 1}}));
    const Probe probe{{{0.6, 0.8, 0}}, {{0.6, 0.8, 0}}, {Vector<Object>{{-0.8, 0.6, 0}}, Vector<Object>{{0, 0, 1}}}};
    const Derivation d = derivation(m, 1, probe);
    EXPECT_EQ(written_out(d.steps[0]), "−0.600·0.800 + 0.800·0.600 + 0·0 = 0");
    EXPECT_EQ(written_out(d.steps[1]), "−1.200·0.400 + 0.400·1.200 + 0·0 = 0");
    EXPECT_EQ(written_out(d.steps[3]), "");  // a product of matrices
    EXPECT_EQ(written_out(derivation(m, 1, std::nullopt).steps[0]), "");
}

// A product that is 0, or of two negative numbers, shows whose sign is whose.
TEST(Derivation, EachFactorThatIsWrittenOutHasItsOwnSign) {
    const auto given = [](const glm::dvec3& n, const glm::dvec3& v) {
        const Probe probe{{n}, {n}, {Vector<Object>{v}, Vector<Object>{{0, 0, 1}}}};
        return written_out(derivation(Transform<World, Object>(glm::dmat4(1.0)), 1, probe).steps[0]);
    };
    EXPECT_EQ(given({1, 0, 0}, {0, 0, -1}), "1.000·0 + 0·0 + 0·(−1.000) = 0");
    EXPECT_EQ(given({0, 1, 0}, {-0.8, 0, -1}), "0·(−0.800) + 1.000·0 + 0·(−1.000) = 0");
    EXPECT_EQ(given({-1, 0, 0}, {0, 1, 0}), "−1.000·0 + 0·1.000 + 0·0 = 0");
    EXPECT_EQ(given({0, -1, 0}, {1, 0, 0}), "0·1.000 + (−1.000)·0 + 0·0 = 0");
    EXPECT_EQ(given({-0.6, -0.8, 0}, {-0.8, 0.6, 0}), "−0.600·(−0.800) − 0.800·0.600 + 0·0 = 0");
}

TEST(Derivation, ResidualsAgainstTheLengthsStayNearTheirFloor) {
    // Relative to |n| |t| no arithmetic in double can do better than ε times the condition number: M t itself is rounded.
    Random random(12);
    for (const double k : {1e2, 1e4, 1e6, 1e8}) {
        double worst = 0.0;
        for (int i = 0; i < 5000; ++i) {
            const glm::dmat3 u = singular_values(random.matrix()).u, v = singular_values(random.matrix()).v;
            const glm::dvec3 sigma(k, random.chance(0.5) ? 1.0 : k, 1.0);
            glm::dmat3 m(0.0);
            for (int c = 0; c < 3; ++c) m += sigma[c] * glm::outerProduct(u[c], v[c]);
            const glm::dmat3 n = *normal_matrices(m).inverse_transpose;
            const glm::dvec3 normal = random.chance(0.3) ? v[0] : random.direction();
            const glm::dvec3 t = glm::normalize(glm::cross(normal, random.direction()));
            worst = std::max(worst, std::abs(glm::dot(glm::normalize(n * normal), glm::normalize(m * t))));
        }
        EXPECT_LE(worst, 1e-14 * k) << "condition " << k;
    }
}

TEST(Derivation, DecompositionMultipliesBack) {
    for_random_explanations(13, 20'000, [&](const Scene&, const Explanation& e) {
        const Decomposition& d = e.decomposition;
        const double size = norm(e.matrices.naive);
        EXPECT_LE(norm(d.rotation * d.stretch - e.matrices.naive), 1e-13 * size);
        EXPECT_LE(norm(glm::transpose(d.rotation) * d.rotation - glm::dmat3(1.0)), 1e-13);
        EXPECT_LE(norm(d.stretch - glm::transpose(d.stretch)), 1e-15 * size);
        EXPECT_EQ(d.reflects, e.matrices.determinant < 0.0);
        EXPECT_NEAR(glm::determinant(d.rotation), d.reflects ? -1.0 : 1.0, 1e-12);
        // The rotation as named: Rodrigues' formula, after a mirror image where it reflects.
        glm::dmat3 named(matrix(Rotate{d.axis, d.degrees}));
        if (d.reflects) named = named * (glm::dmat3(1.0) - 2.0 * glm::outerProduct(d.axis, d.axis));
        EXPECT_LE(norm(named - d.rotation), 1e-7) << d.degrees;
        for (const StretchAxis& axis : d.axes)
            EXPECT_LE(glm::length(e.matrices.naive * axis.from.xyz - axis.factor * axis.to.xyz), 1e-13 * size);
        EXPECT_EQ(d.worst.has_value(), e.matrices.rank == 3);
        if (!d.worst || *e.claims.condition > 1e6) return;
        for (const Normal<Object>& n : d.worst->object)
            EXPECT_NEAR(*error_degrees(e.matrices, n), d.worst->degrees, 1e-9 * *e.claims.condition);
    });
}

TEST(Derivation, EveryMapIsOfSomeClass) {
    for_random_explanations(14, 20'000, [&](const Scene&, const Explanation& e) {
        ASSERT_EQ(e.classes.size(), kMapClasses.size());
        EXPECT_TRUE(std::ranges::any_of(e.classes, [](const MapClassRow& row) { return row.contains_m; }));
        for (const MapClassRow& row : e.classes)
            EXPECT_EQ(row.map_class == MapClass::Singular && row.contains_m,
                      row.map_class == MapClass::Singular && e.matrices.rank < 3);
        EXPECT_EQ(e.claims.inverse_transpose_exists, e.matrices.rank == 3);
    });
}

TEST(Derivation, NothingPrintsWhatIsNoNumber) {
    const std::regex nothing(R"((^|[^a-z])(nan|inf)($|[^a-z]))", std::regex::icase),
        minus_zero(R"((^|[ (\[,])-0($|[ ,)\]}]))");
    for_random_explanations(15, 300, [&](const Scene&, const Explanation& e) {
        for (const std::string& text : {explanation_text(e), explanation_latex(e)}) {
            EXPECT_FALSE(std::regex_search(text, nothing)) << text;
            EXPECT_FALSE(std::regex_search(text, minus_zero)) << text;
        }
    });
}

#if __has_include(<Eigen/Dense>)

using Number = long double;
using M3 = Eigen::Matrix<Number, 3, 3>;
using M4 = Eigen::Matrix<Number, 4, 4>;
using V3 = Eigen::Matrix<Number, 3, 1>;

M4 m4_of(const Json& rows) {
    M4 m;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            m(r, c) = rows.at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c)).get<double>();
    return m;
}
M3 m3_of(const Json& rows) {
    M3 m;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            m(r, c) = rows.at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c)).get<double>();
    return m;
}
V3 v3_of(const Json& a) { return {a.at(0).get<double>(), a.at(1).get<double>(), a.at(2).get<double>()}; }

TEST(Derivation, JsonAgreesWithEigen) {
    Random random(16);
    SurfaceCache surfaces;
    int inverted = 0, flattened = 0;
    for (int i = 0; i < 1500 && !HasFailure(); ++i) {
        SCOPED_TRACE("scene " + std::to_string(i));
        Scene scene;
        scene.surface = ShapeSurface{Shape::Sphere, 6};
        scene.probe = Point<Object>{random.direction()};
        scene.stack = any_stack(random);
        const Frame frame = make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {1280, 720}}});
        const Json j = Json::parse(explanation_json(scene, frame, explanation(scene, frame.probe->object)));

        M4 m = M4::Identity();
        Number growth = 1.0;  // of rounding errors along the stack
        for (const Json& entry : j.at("stack")) {
            const M4 a = m4_of(entry.at("A"));
            growth *= std::max<Number>(a.topLeftCorner<3, 3>().norm(), 1e-30L);
            m = a * m;
            EXPECT_LE((m4_of(entry.at("product")).topLeftCorner<3, 3>() - m.topLeftCorner<3, 3>()).norm(),
                      1e-14L * growth);
        }
        const M3 m3 = m3_of(j.at("M"));  // from here on, M as the program has it
        const Eigen::JacobiSVD<M3> svd(m3, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const V3& sigma = svd.singularValues();
        const int rank = j.at("rank").get<int>();
        int largest_rank = 0;
        while (largest_rank < 3 && sigma[largest_rank] > 8e-16L * sigma[0]) ++largest_rank;
        if (rank > largest_rank) {  // known from the stack, where the determinant has kept its digits
            EXPECT_NEAR(static_cast<double>(j.at("determinant").get<double>() / m3.determinant()), 1.0, 1e-5);
        }
        for (const char* key : {"naive", "inverse-transpose", "cofactor"})
            EXPECT_EQ(j.at("normal_matrix").at(key).is_null(), rank < 3 && std::string(key) == "inverse-transpose");

        const V3 n = v3_of(j.at("probe").at("n_object"));
        if (rank < 3) {
            EXPECT_TRUE(j.at("condition").is_null());
            EXPECT_EQ(j.at("determinant").get<double>(), 0.0);
            EXPECT_TRUE(j.at("derivation").back().at("right").is_null());
            if (rank == 2 && !j.at("check").at("cofactor").at("n_world").is_null() && sigma[1] > 1e-6L * sigma[0]) {
                ++flattened;  // the flattened object's normal is the direction that M3 does not reach
                const V3 cofactor = v3_of(j.at("check").at("cofactor").at("n_world"));
                EXPECT_LE((m3.transpose() * cofactor).norm(), 1e-12L * m3.norm() * m3.norm() * m3.norm());
            }
            continue;
        }
        ++inverted;
        const Number condition = sigma[0] / sigma[2];
        EXPECT_NEAR(static_cast<double>(j.at("condition").get<double>() / condition), 1.0,
                    1e-12 * std::max(1.0, static_cast<double>(condition) * 1e-3));
        const M3 inverse_transpose = m3.fullPivLu().inverse().transpose();
        // The cofactors are right to the last digit, whatever the condition number; the determinant is their sum.
        const Number slack = 1e-14L * condition;
        EXPECT_LE((m3_of(j.at("normal_matrix").at("inverse-transpose")) - inverse_transpose).norm(),
                  slack * inverse_transpose.norm());
        const V3 expected = inverse_transpose * n;
        for (const char* side : {"left", "right"})
            EXPECT_LE((v3_of(j.at("derivation").back().at(side)) - expected).norm(), slack * inverse_transpose.norm());
        if (condition < 1e6L) {
            EXPECT_NEAR(j.at("check").at("naive").at("degrees_off").get<double>(),
                        static_cast<double>(std::acos(std::clamp<Number>(
                                                (m3 * n).normalized().dot(expected.normalized()), -1.0L, 1.0L)) *
                                            180.0L / std::acos(-1.0L)),
                        1e-6);
            const M3 rotation = svd.matrixU() * svd.matrixV().transpose();
            EXPECT_LE((m3_of(j.at("decomposition").at("rotation")) - rotation).norm(), 1e-13L * condition);
        }
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(j.at("decomposition").at("axes").at(k).at("factor").get<double>(),
                        static_cast<double>(sigma[static_cast<Eigen::Index>(k)]),
                        static_cast<double>(1e-14L * sigma[0]));
    }
    EXPECT_GT(inverted, 500);
    EXPECT_GT(flattened, 10);
}

#endif

}  // namespace
}  // namespace normalscope

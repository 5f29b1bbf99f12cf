#include "core/surface/singular_point.h"
#include "core/surface/surface_probe.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <memory>

namespace normalscope {
namespace {

ImplicitSurface surface(const char* formula, double bound = 2.0) {
    return ImplicitSurface({.formula = formula, .bound = bound});
}

std::size_t size_of(const SingularPoint& point) {
    std::size_t size = 0;
    for (const auto& curve : point.fan) size += curve.size();
    return size;
}

// Each normal of the fan is perpendicular to a line of the tangent cone: for the cone, n.y² = n.x² + n.z².
TEST(SingularPoint, AConesApexHasAFanOfNormals) {
    const ImplicitSurface cone = surface("x^2+z^2-y^2");
    EXPECT_TRUE(is_singular(cone, {}));
    EXPECT_FALSE(is_singular(cone, {{0.001, 0.001, 0.0}}));
    const SingularPoint apex = singular_point(cone, {}, Direction<Object>{.azimuth = 90.0, .elevation = 45.0});
    EXPECT_FALSE(apex.undefined);
    ASSERT_EQ(apex.fan.size(), 2u);
    EXPECT_GT(size_of(apex), 200u);
    for (const auto& curve : apex.fan)
        for (const Normal<Object>& n : curve) {
            EXPECT_NEAR(glm::length(n.xyz), 1.0, 1e-12);
            EXPECT_NEAR(n.xyz.y * n.xyz.y, 0.5, 1e-9);
        }
    EXPECT_NEAR(apex.spread_degrees, 180.0, 0.5);
    // Along (1, 1, 0) lies a line of the cone; the normal there is (1, −1, 0)/√2.
    ASSERT_TRUE(apex.lender);
    const double s = std::sqrt(0.5), reach = SingularPoint::kLenders * 2.0;
    EXPECT_NEAR(glm::distance(apex.lender->point.xyz, reach * glm::dvec3(s, s, 0.0)), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(apex.lender->normal.xyz, glm::dvec3(s, -s, 0.0)), 0.0, 1e-6);
}

TEST(SingularPoint, AnApexOfARootHasNoGradientAtAll) {
    const ImplicitSurface cone = surface("sqrt(x^2+z^2)+y");
    const SingularPoint apex = singular_point(cone, {}, std::nullopt);
    EXPECT_TRUE(apex.undefined);
    EXPECT_EQ(apex.fan.size(), 1u);
    EXPECT_NEAR(apex.spread_degrees, 90.0, 0.5);
    EXPECT_FALSE(apex.lender);
}

// 4(a²+b²+c²)·… : Cayley's cubic xyz + xyw + xzw + yzw = 0 with w = 1 − x − y − z has double points at the four corners,
// where three of the four coordinates are 0. At the origin its quadratic part is xy + xz + yz.
TEST(SingularPoint, CayleysDoublePoints) {
    const ImplicitSurface cayley = surface("x*y*z+(x*y+x*z+y*z)*(1-x-y-z)", 3.0);
    for (const glm::dvec3 corner :
         {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        EXPECT_TRUE(is_singular(cayley, {corner}));
        const auto found = singular_near(cayley, {corner + glm::dvec3(0.05, -0.04, 0.03)}, 0.3);
        ASSERT_TRUE(found);
        EXPECT_NEAR(glm::distance(found->xyz, corner), 0.0, 1e-9);
        EXPECT_GT(size_of(singular_point(cayley, {corner}, std::nullopt)), 200u);
    }
    // The normals of xy + xz + yz = 0 are those with n = Q p: pᵀ Q p = nᵀ Q⁻¹ n = 0.
    for (const auto& curve : singular_point(cayley, {}, std::nullopt).fan)
        for (const Normal<Object>& n : curve) {
            const double sum = n.xyz.x + n.xyz.y + n.xyz.z;
            EXPECT_NEAR(sum * sum - 2.0 * glm::dot(n.xyz, n.xyz), 0.0, 0.03);
        }
}

// x² = y² z: along the z axis two sheets cross where z > 0, and there is nothing else where z < 0.
TEST(SingularPoint, WhitneysDoubleLine) {
    const ImplicitSurface whitney = surface("x^2-y^2*z");
    const SingularPoint crossing = singular_point(whitney, {{0.0, 0.0, 1.0}}, Direction<Object>{.azimuth = 60.0});
    EXPECT_FALSE(crossing.fan.empty());
    for (const auto& curve : crossing.fan)
        for (const Normal<Object>& n : curve) {
            EXPECT_NEAR(std::abs(n.xyz.x), std::sqrt(0.5), 0.02);
            EXPECT_NEAR(std::abs(n.xyz.y), std::sqrt(0.5), 0.02);
        }
    ASSERT_TRUE(crossing.lender);
    EXPECT_GT(crossing.lender->point.xyz.x, 0.0);  // 60° is towards x
    const auto near = singular_near(whitney, {{0.02, 0.02, 1.0}}, 0.2);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->xyz.x, 0.0, 1e-9);
    EXPECT_NEAR(near->xyz.y, 0.0, 1e-9);

    const SingularPoint stick = singular_point(whitney, {{0.0, 0.0, -1.0}}, Direction<Object>{});
    EXPECT_TRUE(stick.fan.empty());
    EXPECT_FALSE(stick.lender);
}

TEST(SingularPoint, TheProbeBorrowsOnlyWhenTold) {
    Surface cone;
    cone.implicit = std::make_shared<const ImplicitSurface>(FormulaSurface{.formula = "x^2+z^2-y^2"});
    const auto none = nearest_probe(cone, {});
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->singular);
    EXPECT_FALSE(none->has_normal());
    const ProbeInWorld world = in_world(*none, {});
    for (const auto& n : world.normals) EXPECT_FALSE(n);

    const Direction<Object> borrow{.azimuth = 10.0, .elevation = -40.0};
    const auto borrowed = nearest_probe(cone, {}, borrow);
    ASSERT_TRUE(borrowed && borrowed->borrowed_from);
    EXPECT_NEAR(glm::length(borrowed->normal.xyz), 1.0, 1e-12);
    EXPECT_EQ(borrowed->normal.xyz, nearest_probe(cone, {}, borrow)->normal.xyz);  // and always the same one
    // Elsewhere nothing is borrowed.
    const auto exact = nearest_probe(cone, {{0.6, 1.0, 0.8}}, borrow);
    ASSERT_TRUE(exact);
    EXPECT_FALSE(exact->singular);
    EXPECT_NEAR(glm::distance(exact->normal.xyz, glm::normalize(glm::dvec3(0.6, -1.0, 0.8))), 0.0, 1e-12);
}

// (|p|² − 1)² is zero with its gradient all over the sphere; to either side of it the gradient points away from it.
TEST(SingularPoint, ADoubledSphereHasTwoLimits) {
    const ImplicitSurface doubled = surface("(x^2+y^2+z^2-1)^2");
    const glm::dvec3 at(0.48, 0.6, 0.64);
    const SingularPoint point = singular_point(doubled, {at}, Direction<Object>{.azimuth = 30.0, .elevation = 30.0});
    ASSERT_EQ(point.fan.size(), 2u);
    for (const auto& side : point.fan) EXPECT_NEAR(std::abs(glm::dot(side.at(0).xyz, at)), 1.0, 1e-4);
    EXPECT_NEAR(glm::dot(point.fan[0][0].xyz, point.fan[1][0].xyz), -1.0, 1e-4);
    ASSERT_TRUE(point.lender);
    EXPECT_NEAR(glm::dot(point.lender->normal.xyz, at), 1.0, 1e-4);
}

// Rounding makes f and its gradient there nearly 0, and their quotient anything.
TEST(SingularPoint, AProbeOnANodeStays) {
    const double s = std::sqrt(2.5);
    const ImplicitSurface tanglecube = surface("x^4-5x^2+y^4-5y^2+z^4-5z^2+12.5", 3.0);
    const auto probe = nearest_probe({.implicit = std::make_shared<const ImplicitSurface>(tanglecube)}, {{s, s, 0.0}});
    ASSERT_TRUE(probe);
    EXPECT_TRUE(probe->singular);
    EXPECT_EQ(probe->point.xyz, glm::dvec3(s, s, 0.0));
}

TEST(SingularPoint, AKinkHasNoGradient) {
    const ImplicitSurface octahedron = surface("|x|+|y|+|z|=1"), cube = surface("max(|x|,|y|,|z|)=1");
    for (const glm::dvec3 at : {glm::dvec3(0, 1, 0), glm::dvec3(0.5, 0.5, 0), glm::dvec3(0, 0.4, 0.6)})
        EXPECT_TRUE(is_singular(octahedron, {at}));
    EXPECT_FALSE(is_singular(octahedron, {{0.5, 0.4, 0.1}}));
    EXPECT_TRUE(is_singular(cube, {{1, 1, 0.3}}));
    EXPECT_FALSE(is_singular(cube, {{1, 0, 0}}));
    const SingularPoint corner = singular_point(octahedron, {{0, 1, 0}}, Direction<Object>{});
    EXPECT_TRUE(corner.undefined);
    EXPECT_GE(corner.fan.size(), 4u);  // one a face
    EXPECT_NEAR(corner.spread_degrees, glm::degrees(std::acos(-1.0 / 3.0)), 1e-6);
    ASSERT_TRUE(corner.lender);
    // What only looks like one is none.
    for (const char* smooth : {"|x|^3+y", "max(y-x^2, y+x^2)", "where(y, x, y-x^3)", "x|x|+y", "where(y, x, 2y)"})
        EXPECT_FALSE(is_singular(surface(smooth), {{0, 0, 0.3}})) << smooth;
}

TEST(SingularPoint, HoweverSteeplyFGrows) {
    EXPECT_FALSE(is_singular(surface("sinh(300(x^2+y^2+z^2))=sinh(300)"), {{1, 0, 0}}));
    EXPECT_FALSE(is_singular(surface("sinh(1000x)=y"), {{0, 0, 0}}));
    EXPECT_FALSE(is_singular(surface("cosh(300x)=y"), {{0, 1, 0}}));
    EXPECT_FALSE(is_singular(surface("exp(1000x)-exp(-1000x)=y"), {{0, 0, 0}}));
    EXPECT_TRUE(is_singular(surface("x^2+y^2=sinh(1000z)^2"), {{0, 0, 0}}));
    EXPECT_FALSE(surface("y=sinh(750x)").onto_surface({{0.76, 0.55, 0.35}}, 0.1));  // where ∇f has no square
    EXPECT_FALSE(is_singular(surface("x^1000-y"), {{1, 1, 0}}));
    EXPECT_FALSE(is_singular(surface("cosh(400x)-cosh(200)"), {{0.5, 0.3, 0}}));
}

TEST(SingularPoint, ASmoothSurfaceHasNone) {
    const ImplicitSurface sphere = surface("x^2+y^2+z^2-1");
    EXPECT_FALSE(is_singular(sphere, {{1.0, 0.0, 0.0}}));
    EXPECT_FALSE(singular_near(sphere, {{0.6, 0.0, 0.8}}, 0.4));
}

}  // namespace
}  // namespace normalscope

// What is a surface and what only looks like one: poles, jumps, sheets thinner than any grid, and what is said of them.

#include "core/surface/surface.h"
#include "core/surface/surface_probe.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace normalscope {
namespace {

std::string note_of(const Surface& surface) { return surface.mesh.notes.empty() ? "" : surface.mesh.notes.front(); }

std::shared_ptr<const Surface> surface_of(std::string formula, double bound = 2.0) {
    Scene scene;
    scene.surface = FormulaSurface{.formula = std::move(formula), .bound = bound};
    return SurfaceCache().get(scene);
}

std::size_t hits_of(const ImplicitSurface& surface) {
    std::size_t hits = 0;
    const double bound = surface.source().bound;
    for (int k = 0; k < 400; ++k) {
        const int row = k / 20, column = k % 20;
        const glm::dvec3 from(-3.0, (column + 0.3) / 10.0 - 1.0, (row + 0.7) / 10.0 - 1.0);
        const Ray<Object> ray{{bound * from}, {glm::normalize(glm::dvec3(1.0, 0.05, 0.07))}};
        for (const formulas::Root& root : surface.hits(ray, formulas::Wanted::All)) {
            ++hits;
            EXPECT_TRUE(root.touches || surface.lies_on((ray.origin + root.t * ray.direction).xyz))
                << surface.source().formula;
        }
    }
    return hits;
}

constexpr std::array kProbes{glm::dvec3(0.15, 0.2, 0.1), glm::dvec3(0.9, 0.1, 0.1), glm::dvec3(-0.3, 0.5, -0.6)};

TEST(FormulaSurface, PolesAndJumpsAreNone) {
    for (const char* formula : {"1/(x^2+y^2+z^2-1)", "1/(x^2+y^2-1)", "1/(x^3-x)", "1/(z-0.3)", "1/x^2", "-1/(x-y)^3",
                                "floor(x)+0.5", "sign(x+y)", "heaviside(x)-0.25", "where(1, x, -1)"}) {
        const auto surface = surface_of(formula);
        EXPECT_TRUE(surface->mesh.triangles.empty()) << formula;
        EXPECT_NE(note_of(*surface).find("No zero"), std::string::npos) << formula << ": " << note_of(*surface);
        EXPECT_FALSE(surface->implicit->region()) << formula;
        EXPECT_EQ(hits_of(*surface->implicit), 0u) << formula;
        for (const glm::dvec3& p : kProbes) EXPECT_FALSE(nearest_probe(*surface, {2.0 * p}, std::nullopt)) << formula;
    }
}

TEST(FormulaSurface, BesidePolesAndJumpsOnlyTheZeros) {
    struct Case {
        const char* formula;
        double (*distance)(const glm::dvec3& p);  // from what the surface is, or is a part of
    };
    for (const auto& [formula, distance] : std::initializer_list<Case>{
             {"x/(x^2+y^2+z^2-1)", [](const glm::dvec3& p) { return std::abs(p.x); }},
             {"(x^2+y^2-4)/(x-0.3)", [](const glm::dvec3& p) { return std::abs(std::hypot(p.x, p.y) - 2.0); }},
             {"tan(x+0.2)", [](const glm::dvec3& p) { return std::abs(std::sin(p.x + 0.2)); }},
             {"tan(x^2+y^2+z^2)", [](const glm::dvec3& p) { return std::abs(std::sin(glm::dot(p, p))); }},
             {"mod(x,1)-0.5", [](const glm::dvec3& p) { return std::abs(p.x - std::floor(p.x) - 0.5); }},
             {"z-floor(2x)/4", [](const glm::dvec3& p) { return std::abs(p.z - std::floor(2.0 * p.x) / 4.0); }},
             {"atan2(y,x)", [](const glm::dvec3& p) { return p.x > 0.0 ? std::abs(p.y) : 1.0; }},
         }) {
        const auto surface = surface_of(formula, 2.5);
        EXPECT_GT(surface->mesh.triangles.size(), 500u) << formula;
        EXPECT_EQ(note_of(*surface), "") << formula;
        for (const glm::dvec3& p : surface->mesh.positions)
            ASSERT_LT(distance(p), 1e-5) << formula << " at " << p.x << " " << p.y << " " << p.z;
        EXPECT_GT(hits_of(*surface->implicit), 10u) << formula;
        for (const glm::dvec3& p : kProbes) {
            const auto probe = nearest_probe(*surface, {2.5 * p}, std::nullopt);
            ASSERT_TRUE(probe) << formula;
            EXPECT_LT(distance(probe->point.xyz), 1e-9) << formula;
        }
    }
}

TEST(FormulaSurface, HoweverThinOrSmall) {
    for (const auto& [formula, bound] :
         std::initializer_list<std::pair<const char*, double>>{{"z^2 = 0.0001(1-x^2-y^2)", 1.2},
                                                               {"(x+y-z)^2 = 1e-6(1-x^2-y^2)", 1.5},
                                                               {"x^2+y^2 = 1e-6", 2.0},
                                                               {"(x-900)^2+y^2+z^2 = 1", 1000.0},
                                                               {"(x+y+z)^250-1", 2.0},
                                                               {"x^500-0.5", 2.0},
                                                               {"exp(1e3 x) - 1", 2.0},
                                                               {"exp(-1000x^2)-1e-300", 2.0},
                                                               {"exp(-exp(10x))-1e-300", 2.0},
                                                               {"x^200-1e-300", 2.0},
                                                               {"x^100*y^100*z^100-1e-200", 2.0},
                                                               {"1e-320(x^2+y^2+z^2-1)", 2.0},
                                                               {"1e300(x^2+y^2+z^2-1)", 2.0},
                                                               {"exp(-100(x^2+y^2+z^2)) = exp(-100)", 1.5}}) {
        const auto surface = surface_of(formula, bound);
        EXPECT_GT(surface->mesh.triangles.size(), 100u) << formula;
        EXPECT_GT(surface->arrows.size(), 5u) << formula;
        EXPECT_EQ(note_of(*surface), "") << formula;
        for (const glm::dvec3& p : kProbes) {
            const auto probe = nearest_probe(*surface, {bound * p}, std::nullopt);
            ASSERT_TRUE(probe) << formula;
            EXPECT_TRUE(surface->implicit->lies_on(probe->point.xyz)) << formula;
            EXPECT_TRUE(probe->has_normal()) << formula;
        }
    }
}

// x^200 is less than any number about x = 0, and 0 only there.
TEST(FormulaSurface, UnderflowIsNotZero) {
    for (const auto& [formula, distance] : std::initializer_list<std::pair<const char*, double (*)(const glm::dvec3&)>>{
             {"x^200", [](const glm::dvec3& p) { return p.x; }},
             {"x^199", [](const glm::dvec3& p) { return p.x; }},
             {"x^201-y^201", [](const glm::dvec3& p) { return p.x - p.y; }},
             {"(x-0.3)^50*(y-0.2)^50*1e-200", [](const glm::dvec3& p) { return (p.x - 0.3) * (p.y - 0.2); }},
             {"(x^2+y^2+z^2-1)^101", [](const glm::dvec3& p) { return glm::length(p) - 1.0; }}}) {
        const auto surface = surface_of(formula, 2.0);
        for (const glm::dvec3& p : kProbes) {
            const auto probe = nearest_probe(*surface, {2.0 * p}, std::nullopt);
            if (probe) {
                EXPECT_NEAR(distance(probe->point.xyz), 0.0, 1e-6) << formula;
            }
        }
    }
}

TEST(FormulaSurface, WhatIsSaidIsSo) {
    for (const auto& [formula, says, drawn] : std::initializer_list<std::tuple<const char*, const char*, bool>>{
             {"(x-0.3)^2", "touches 0", true},
             {"|x-0.3|", "touches 0 within the ball without changing its sign", true},
             {"x^2+0.09-0.6x", "touches 0 within the ball, and was not found to change its sign", true},
             {"x^200", "touches 0 within the ball without changing its sign", true},
             {"x^200+y^200", "never negative", false},
             {"exp(-exp(x))", "No zero", false},
             {"x^x-0.5", "No zero", false},
             {"(x^2+y^2+z^2-4)^2+((x-1)^2+y^2-1)^2", "never negative", false},
             {"sqrt(1-x^2-y^2-z^2)", "only where it stops being defined", false},
             {"x^2+y^2+z^2-1e-9", "too small to be seen", true}}) {
        const auto surface = surface_of(formula, 2.5);
        EXPECT_NE(note_of(*surface).find(says), std::string::npos) << formula << ": " << note_of(*surface);
        EXPECT_EQ(surface->implicit->region().has_value(), drawn) << formula;
    }
}

TEST(FormulaSurface, FloatsAreHeldAgainstDoubles) {
    using formulas::Precision;
    for (const auto& [formula, bound, precision] : std::initializer_list<std::tuple<const char*, double, Precision>>{
             {"x^2+y^2+z^2-1", 1.5, Precision::Single},
             {"4(x^2+y^2+z^2)+16x y z-1", 1.5, Precision::Single},
             {"sin(3x)cos(3y)+sin(3y)cos(3z)+sin(3z)cos(3x)", 2.0, Precision::Single},
             {"exp(-100(x^2+y^2+z^2)) = exp(-100)", 1.5, Precision::Single},  // as the sphere
             {"exp(-100(x^2+y^2+z^2)) + exp(-100(x^2+y^2+z^2)-1) = 5e-44", 1.5, Precision::Double},
             {"(x+1000)^2-1000^2+(y+1000)^2-1000^2+(z+1000)^2-1000^2-2000(x+y+z)-1", 1.5, Precision::Double}})
        EXPECT_EQ(surface_of(formula, bound)->implicit->precision(), precision) << formula;
}

}  // namespace
}  // namespace normalscope

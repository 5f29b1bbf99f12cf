#include "core/surface/level_sets.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace normalscope {
namespace {

ImplicitSurface surface(const char* formula, double bound = 2.0, Clip clip = Clip::Ball) {
    return ImplicitSurface({.formula = formula, .bound = bound, .clip = clip});
}

double area(const LevelSets& sets) {
    double sum = 0.0;
    for (const LevelSets::Patch& p : sets.patches)
        sum += 0.5 * glm::length(glm::cross(p.corners[1] - p.corners[0], p.corners[2] - p.corners[0]));
    return sum;
}

TEST(Slice, LinesLieOnTheirLevelsAndBandsBetweenThem) {
    const ImplicitSurface sphere = surface("x^2+y^2+z^2-1");
    const LevelSets sets = level_sets(sphere, {.axis = Axis::Y, .at = 0.3});
    EXPECT_EQ(sets.step, 0.5);
    ASSERT_FALSE(sets.lines.empty());
    for (const LevelSets::Line& line : sets.lines)
        for (const glm::dvec3& end : line.ends) {
            EXPECT_NEAR(sphere.at({end}).value, line.level * sets.step, 2e-3);
            EXPECT_EQ(end.y, 0.3);
        }
    for (const LevelSets::Patch& patch : sets.patches) {
        const double f = sphere.at({(patch.corners[0] + patch.corners[1] + patch.corners[2]) / 3.0}).value;
        EXPECT_GE(f, patch.band * sets.step - 2e-3);
        EXPECT_LE(f, (patch.band + 1) * sets.step + 2e-3);
    }
    EXPECT_NEAR(area(sets), std::numbers::pi * (4.0 - 0.09), 0.01);  // nothing is left out, nothing twice
    ASSERT_TRUE(sets.inside && sets.outside);
    EXPECT_LT(sphere.at({*sets.inside}).value, 0.0);
    EXPECT_GT(sphere.at({*sets.outside}).value, 0.0);
    for (const LevelSets::Arrow& arrow : sets.gradients) EXPECT_EQ(arrow.gradient.xyz, 2.0 * arrow.base.xyz);
}

TEST(Slice, WhatHasNoFiniteValueStaysBlank) {
    const LevelSets half = level_sets(surface("log(x)"), {});
    ASSERT_FALSE(half.patches.empty());
    for (const LevelSets::Patch& patch : half.patches)
        for (const glm::dvec3& corner : patch.corners) EXPECT_GT(corner.x, 0.0);
    EXPECT_NEAR(area(half), 2.0 * std::numbers::pi, 0.01);  // up to the last point that has a value

    // f jumps from −∞ to ∞ over x = 0.013: no line f = 0 there.
    const LevelSets pole = level_sets(surface("1/(x-0.013)"), {});
    for (const LevelSets::Line& line : pole.lines) EXPECT_NE(line.level, 0);
    for (const LevelSets::Arrow& arrow : pole.gradients) EXPECT_TRUE(std::isfinite(glm::length(arrow.gradient.xyz)));

    EXPECT_TRUE(level_sets(surface("sqrt(-1-x^2)"), {}).patches.empty());
    EXPECT_TRUE(level_sets(surface("x^2+y^2+z^2-1"), {.at = 2.5}).patches.empty());
    EXPECT_NEAR(area(level_sets(surface("x", 1.5, Clip::Box), {.at = 1.0})), 9.0, 1e-9);
}

TEST(Slice, IsKeptWhileNothingChanges) {
    Scene scene;
    scene.surface = FormulaSurface{};
    scene.slice = Slice{};
    const auto sphere = std::make_shared<const ImplicitSurface>(FormulaSurface{});
    LevelSetsCache cache;
    const auto first = cache.get(scene, sphere);
    EXPECT_EQ(cache.get(scene, sphere), first);
    scene.slice->at = 0.1;
    EXPECT_NE(cache.get(scene, sphere), first);
    scene.slice.reset();
    EXPECT_FALSE(cache.get(scene, sphere));
}

}  // namespace
}  // namespace normalscope

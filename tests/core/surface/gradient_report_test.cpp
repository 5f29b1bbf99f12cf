#include "core/surface/gradient_report.h"
#include "core/lessons/open.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace normalscope {
namespace {

Surface surface_of(const FormulaSurface& source) {
    SurfaceCache cache;
    Scene scene;
    scene.surface = source;
    return *cache.get(scene);
}

TEST(GradientReport, ThreeWaysToTheNormal) {
    const Surface torus = surface_of(
        {.formula = "(x^2+y^2+z^2+a^2-b^2)^2 - 4a^2(x^2+z^2)", .parameters = {1, 0.4, 1, 1, 1, 1, 1}, .bound = 1.6});
    const Probe probe = *nearest_probe(torus, {{1.0, 0.4, 0.1}});
    const GradientReport report = *gradient_report(torus, probe);
    EXPECT_LT(std::abs(report.f), 1e-14);
    // Of a torus the normal leads away from the circle in its middle.
    const glm::dvec3 p = probe.point.xyz, flat(p.x, 0.0, p.z), outward = glm::normalize(p - glm::normalize(flat));
    EXPECT_LT(glm::distance(report.normal->xyz, outward), 1e-13);
    EXPECT_LT(*report.differences.degrees_off, 1e-3);
    EXPECT_GT(*report.differences.degrees_off, 0.0);
    EXPECT_LT(*report.polygon->degrees_off, 10.0);
    EXPECT_GT(*report.polygon->degrees_off, *report.differences.degrees_off);
}

TEST(GradientReport, SaysWhereThereIsNone) {
    const Surface cone = surface_of({.formula = "x^2+z^2=y^2"});
    const GradientReport apex = *gradient_report(cone, *nearest_probe(cone, {{0, 0, 0}}));
    EXPECT_FALSE(apex.normal);
    EXPECT_FALSE(apex.differences.degrees_off);
    Scene sphere;
    SurfaceCache cache;
    EXPECT_FALSE(gradient_report(*cache.get(sphere), *nearest_probe(*cache.get(sphere), {{1, 0, 0}})));
}

// A formula's arrows stand on it, as near as rounding lets them.
TEST(GradientReport, ArrowsStandOnTheSurface) {
    for (const char* formula : {"x^2+y^2+z^2=1", "4(x^2+y^2+z^2)+16xyz=1", "x^2=y z^2", "|x|^3+|y|^3+|z|^3=1",
                                "sin(3x)cos(3y)+sin(3y)cos(3z)+sin(3z)cos(3x)"}) {
        const Surface surface = surface_of({.formula = formula, .bound = 1.5});
        ASSERT_FALSE(surface.arrows.empty()) << formula;
        for (const Site& site : surface.arrows) {
            const formulas::Sample s = surface.implicit->at(site.point);
            EXPECT_LE(std::abs(s.value), 1e-9 * glm::length(s.gradient)) << formula;
            EXPECT_LT(glm::distance(glm::normalize(s.gradient), site.normal.xyz), 1e-6) << formula;
        }
    }
}

TEST(GradientReport, RaysEndOnTheSurfacesOfTheGallery) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const BuiltInScene& built_in : built_in_scenes()) {
        if (!built_in.name.starts_with(kGalleryPrefix)) continue;
        const ImplicitSurface surface(std::get<FormulaSurface>(load_scene(built_in.name).surface));
        const double bound = surface.source().bound;
        std::size_t hits = 0;
        for (int i = 0; i < 300; ++i) {
            const Ray<Object> ray{{3.0 * bound * glm::normalize(glm::dvec3(unit(random), unit(random), unit(random)))},
                                  {}};
            const glm::dvec3 toward = 0.6 * bound * glm::dvec3(unit(random), unit(random), unit(random));
            const Ray<Object> aimed{ray.origin, {toward - ray.origin.xyz}};
            for (const formulas::Root& root : surface.hits(aimed, formulas::Wanted::All)) {
                const Point<Object> p = aimed.origin + root.t * aimed.direction;
                const formulas::Sample s = surface.at(p);
                ++hits;
                // Where f touches 0 it is flat, and rounding moves the place by the root of what it does to f.
                EXPECT_LE(std::abs(s.value), 1e-10 * (glm::length(s.gradient) + 1.0) * bound) << built_in.name;
                EXPECT_LE(glm::length(p.xyz), 1.8 * bound) << built_in.name;
            }
        }
        EXPECT_GT(hits, 100u) << built_in.name;
    }
}

}  // namespace
}  // namespace normalscope

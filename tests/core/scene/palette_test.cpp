#include "core/scene/palette.h"
#include "core/frame/frame.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {
namespace {

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

// What a viewer without the middle cones sees (Machado, Oliveira and Fernandes 2009, severity 1), as CIE L*a*b*.
glm::dvec3 as_deuteranopes_see(const glm::vec3& srgb) {
    const glm::dmat3 rows(0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881);
    const glm::dvec3 seen = glm::clamp(glm::dvec3(linear(srgb.r), linear(srgb.g), linear(srgb.b)) * rows, 0.0, 1.0);
    const glm::dmat3 xyz_rows(0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920,
                              0.9503041);
    const glm::dvec3 xyz = seen * xyz_rows / glm::dvec3(0.95047, 1.0, 1.08883);
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    return {116.0 * f(xyz.y) - 16.0, 500.0 * (f(xyz.x) - f(xyz.y)), 200.0 * (f(xyz.y) - f(xyz.z))};
}

// The arrows that stand beside each other on one object. The kinds have shapes of their own, besides.
TEST(ColorBlind, TheRulesStayApart) {
    const std::array colors{kNaiveColor, kInverseTransposeColor, kCofactorColor, kTangentColor};
    for (std::size_t i = 0; i < colors.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_GT(glm::length(as_deuteranopes_see(colors[i]) - as_deuteranopes_see(colors[k])), 15.0) << i << k;
    EXPECT_GT(glm::length(as_deuteranopes_see(kNaiveColor) - as_deuteranopes_see(kInverseTransposeColor)), 50.0);
}

// On the object, arrows whose colours look alike have different heads, or one kind is much thinner.
TEST(ColorBlind, ArrowsOnTheObjectStayApart) {
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::LightContrast, Theme::DarkContrast}) {
        Scene scene;
        scene.theme = theme;
        scene.view = ViewMode::Overlay;
        scene.stack = {Scale{{0.5, 2.0, 1.0}}};
        scene.arrows.show = {kArrowKinds.begin(), kArrowKinds.end()};
        SurfaceCache surfaces;
        const Frame frame = make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {320, 240}}});
        const std::vector<ArrowDraw>& arrows = frame.panes.front().arrows;
        ASSERT_EQ(arrows.size(), kArrowKinds.size());
        for (std::size_t i = 0; i < arrows.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_TRUE(
                    glm::length(as_deuteranopes_see(arrows[i].color) - as_deuteranopes_see(arrows[k].color)) > 15.0 ||
                    arrows[i].look != arrows[k].look ||
                    std::max(arrows[i].radius, arrows[k].radius) > 1.5f * std::min(arrows[i].radius, arrows[k].radius))
                    << i << k;
    }
}

// Words against what they stand on, as WCAG 2 has it: 7 : 1 for the themes of lecture halls, 4.5 : 1 for all.
TEST(ColorBlind, WordsHaveContrast) {
    const auto luminance = [](const glm::vec3& c) {
        return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
    };
    for (const Theme theme : {Theme::Light, Theme::Dark, Theme::LightContrast, Theme::DarkContrast}) {
        const ThemeColors colors = theme_colors(theme);
        const double a = luminance(colors.text) + 0.05, b = luminance(colors.background_bottom) + 0.05;
        EXPECT_GT(std::max(a, b) / std::min(a, b), has_contrast(theme) ? 18.0 : 4.5);
    }
}

}  // namespace
}  // namespace normalscope

#include "core/picture/ground.h"

#include "core/frame/picture_scale.h"
#include "core/picture/pixel_bounds.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace normalscope {

namespace {

// The blob under the object: the shadow of M's image of a ball in light from straight above. With A the x and z
// rows of M3, the shadow is the ellipse pᵀ (A Aᵀ)⁻¹ p ≤ 1; Cholesky's A Aᵀ = L Lᵀ turns it into the disc |L⁻¹ p| ≤ 1.
glm::mat3 shadow_disc(const Transform<World, Object>& any, double radius, double unit) {
    const Transform<World, Object> m = any.at({});
    const glm::dmat3 m3 = radius * m.normal_matrices_by_rule().naive;
    const glm::dvec3 x(m3[0].x, m3[1].x, m3[2].x), z(m3[0].z, m3[1].z, m3[2].z);
    const double kSoft = 0.02 * unit * unit;  // keeps the shadow of a flattened object from vanishing
    const double l11 = std::sqrt(glm::dot(x, x) + kSoft), l21 = glm::dot(x, z) / l11;
    const double l22 = std::sqrt(std::max(glm::dot(z, z) + kSoft - l21 * l21, kSoft));
    const glm::dvec3 centre = m(Point<Object>{}).xyz;
    glm::dmat3 disc(1.0 / l11, -l21 / (l11 * l22), 0.0, 0.0, 1.0 / l22, 0.0, 0.0, 0.0, 1.0);
    disc[2] -= disc * glm::dvec3(centre.x, centre.z, 0.0);
    return drawable(disc);
}

}  // namespace

float ground_height(const Mesh& mesh, const Transform<World, Object>& m, bool ghost, double unit) {
    constexpr double kHighest = 1e12;
    double lowest = kHighest;
    // A few thousand vertices tell it well enough, every frame.
    const std::size_t step = 1 + mesh.positions.size() / 20000;
    for (std::size_t i = 0; i < mesh.positions.size(); i += step) {
        const Point<Object> p{mesh.positions[i]};
        if (m.reaches(p)) lowest = std::min(lowest, m(p).xyz.y);
        if (ghost) lowest = std::min(lowest, p.xyz.y);
    }
    return static_cast<float>(std::clamp(lowest, -kHighest, kHighest) - 0.01 * unit);
}

glm::mat3 shadow_from_ground(const Surface& surface, const Transform<World, Object>& world_from_object, double unit) {
    const bool casts_one = !surface.mesh.triangles.empty() || (surface.implicit && surface.implicit->region());
    // That of the unit ball, which most objects fill more or less; one that is much smaller has a small one.
    const double largest = std::max({surface.extent.x, surface.extent.y, surface.extent.z});
    if (casts_one) return shadow_disc(world_from_object, largest > 0.0 ? std::min(2.5 * largest, 1.0) : 1.0, unit);
    return glm::mat3(glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(100.0f));  // all of the ground lies far outside
}

PixelRect ground_box(const Frame& frame, const Pane& pane) {
    if (!frame.ground_height) return {pane.rect.origin, {0, 0}};
    const double grid = frame.unit / std::sqrt(kGridFade), shadow = 1.0 / std::sqrt(kShadowFade);
    const glm::dmat3 to_shadow(frame.shadow_from_ground);
    const bool casts_shadow = glm::determinant(to_shadow) != 0.0;
    const glm::dmat3 from_shadow = casts_shadow ? glm::inverse(to_shadow) : glm::dmat3(0.0);
    constexpr int kCorners = 16;  // of a polygon around a circle
    const double around = 1.0 / std::cos(std::numbers::pi / kCorners);
    PixelBounds bounds(pane.view);
    const auto add = [&](const glm::dvec2& at) { bounds.add({at.x, *frame.ground_height, at.y}); };
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kCorners;
        const glm::dvec2 corner = around * glm::dvec2(std::cos(angle), std::sin(angle));
        add(grid * corner);
        if (casts_shadow) add(glm::dvec2(from_shadow * glm::dvec3(shadow * corner, 1.0)));
    }
    PixelRect box = bounds.box(pane.rect.size);
    box.origin += pane.rect.origin;
    return box;
}

}  // namespace normalscope

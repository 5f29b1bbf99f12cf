#include "core/frame/picture_scale.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

// For objects of a radius from 1/kOrdinaryPart to kOrdinary a unit is one. A small one would soon be lost behind its marks.
constexpr double kOrdinary = 8.0, kOrdinaryPart = 3.0;

}  // namespace

// 1 next to 1, the radius itself far from it, and nowhere a leap.
double picture_unit(double radius) {
    if (!(radius > 0.0) || !std::isfinite(radius)) return 1.0;
    const double away = std::max(radius, 1.0 / radius);
    const double ordinary = radius > 1.0 ? kOrdinary : kOrdinaryPart;
    const double by = away <= ordinary ? 1.0 : std::min(away * away / (ordinary * ordinary), away);
    return radius > 1.0 ? by : 1.0 / by;
}

glm::dvec3 drawn_extent(const Surface& surface) {
    if (!surface.implicit || !surface.implicit->region()) return surface.extent;
    return glm::max(glm::abs(surface.implicit->region()->low), glm::abs(surface.implicit->region()->high));
}

double picture_unit(const Surface& surface, const Transform<World, Object>& world_from_object) {
    const glm::dvec3 extent = surface.extent;
    return picture_unit(std::max({extent.x, extent.y, extent.z}) *
                        world_from_object.at({}).normal_matrices_by_rule().sigma.x);
}

double farthest_depth(const Surface& surface, const Transform<World, Object>& world_from_object,
                      const CameraView& view) {
    double farthest = 0.0;
    const auto add = [&](const glm::dvec3& p) {
        if (world_from_object.reaches({p}))
            farthest = std::max(farthest, view.pixel(world_from_object(Point<Object>{p})).z);
    };
    if (world_from_object.affine()) {
        const glm::dvec3 extent = drawn_extent(surface);
        for (int k = 0; k < 8; ++k) add(glm::mix(-extent, extent, glm::bvec3(k & 1, k & 2, k & 4)));
        return farthest;
    }
    // A box may reach to infinity that the object in it does not.
    const std::size_t step = 1 + surface.mesh.positions.size() / 20000;
    for (std::size_t i = 0; i < surface.mesh.positions.size(); i += step) add(surface.mesh.positions[i]);
    return farthest;
}

}  // namespace normalscope

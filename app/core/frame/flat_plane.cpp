#include "core/frame/flat_plane.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr double kNothing = 1e-9;

// Seen from the side to which z points, or else from above, or from the right.
glm::dvec3 toward_front(const glm::dvec3& n) {
    for (const glm::length_t k : {2, 1, 0})
        if (std::abs(n[k]) > kNothing) return n[k] < 0.0 ? -n : n;
    return {0.0, 0.0, 1.0};
}

// The plane through the origin and along `line` that faces z most.
glm::dvec3 facing_front(const glm::dvec3& line) {
    const glm::dvec3 z(0.0, 0.0, 1.0), rest = z - glm::dot(z, line) * line;
    return glm::length(rest) > 1e-6 ? glm::normalize(rest) : glm::dvec3(1.0, 0.0, 0.0);
}

}  // namespace

Camera FlatPlane::straight_on(const Camera& camera) const {
    Camera straight = camera;
    straight.azimuth = glm::degrees(std::atan2(normal.x, normal.z));
    straight.elevation = glm::degrees(std::asin(std::clamp(normal.y, -1.0, 1.0)));
    straight.target.xyz -= glm::dot(straight.target.xyz - origin.xyz, normal) * normal;
    return straight;
}

FlatPlane flat_plane(const Transform<World, Object>& world_from_object) {
    FlatPlane plane;
    const Transform<World, Object> m = world_from_object.at({});
    const glm::dvec3 u = m(Vector<Object>{{1.0, 0.0, 0.0}}).xyz, v = m(Vector<Object>{{0.0, 1.0, 0.0}}).xyz;
    const double lu = glm::length(u), lv = glm::length(v);
    const glm::dvec3 across = lu > 0.0 && lv > 0.0 ? glm::cross(u / lu, v / lv) : glm::dvec3(0.0);
    plane.origin = m(Point<Object>{});
    if (const auto& planes = world_from_object.planes()) {
        const glm::dvec4 image = *planes * glm::dvec4(0.0, 0.0, 1.0, 0.0);
        if (const double length = glm::length(glm::dvec3(image)); length > 0.0) {
            plane.normal = toward_front(glm::dvec3(image) / length);
            plane.origin = {-image.w / (length * length) * glm::dvec3(image)};
        }
    } else if (std::max(lu, lv) < kNothing) {
        plane.image = FlatPlane::Image::Point;
    } else if (std::min(lu, lv) < kNothing * std::max(lu, lv) || glm::length(across) < kNothing) {
        plane.image = FlatPlane::Image::Line;
        plane.normal = facing_front(lu > lv ? u / lu : v / lv);
    } else {
        plane.normal = toward_front(glm::normalize(across));
    }
    plane.tilted = std::abs(plane.normal.z) < 1.0 - kNothing;
    if (!plane.tilted) plane.normal = {0.0, 0.0, 1.0};
    const CameraView view(plane.straight_on({}), {1.0, 1.0});
    plane.right = view.right().xyz;
    plane.up = view.up().xyz;
    return plane;
}

}  // namespace normalscope

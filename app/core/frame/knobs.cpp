#include "core/frame/knobs.h"

#include "core/surface/ray_steps.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

// What one drags to should be numbers one can say.
glm::dvec3 in_hundredths(const glm::dvec3& v) { return glm::round(100.0 * v) / 100.0 + 0.0; }

}  // namespace

std::vector<Knob> knobs(const Scene& scene, const Transform<World, Object>& world_from_object, const CameraView& view) {
    std::vector<Knob> result;
    if (scene.ray) {
        const auto [from, toward] = aim(*scene.ray, scene.camera, view);
        result.push_back({Knob::What::RayFrom, from, {}});
        result.push_back({Knob::What::RayToward, toward, {}});
    }
    const FormulaSurface* formula = std::get_if<FormulaSurface>(&scene.surface);
    if (!scene.slice || !formula) return result;
    const auto axis = static_cast<glm::length_t>(scene.slice->axis);
    // Beyond the plane's edge, on the side that is to the right or above in the picture.
    const double bound = formula->bound,
                 edge = formula->clip == Clip::Box
                            ? bound
                            : std::sqrt(std::max(bound * bound - scene.slice->at * scene.slice->at, 0.0));
    Point<Object> at;
    at.xyz[axis] = scene.slice->at;
    at.xyz[(axis + 2) % 3] = 1.06 * edge;
    Vector<Object> along;
    along.xyz[axis] = 1.0;
    if (const Vector<World> image = world_from_object(at, along);
        world_from_object.reaches(at) && glm::length(image.xyz) > 1e-12)
        result.push_back({Knob::What::Slice, world_from_object(at), image});
    return result;
}

std::optional<Knob> knob_at(const std::vector<Knob>& knobs, const CameraView& view, glm::dvec2 pixel, double reach) {
    std::optional<Knob> found;
    double nearest = 0.0;
    for (const Knob& knob : knobs) {
        const glm::dvec3 at = view.pixel(knob.at);
        if (at.z <= 0.0 || glm::length(glm::dvec2(at) - pixel) > reach || (found && at.z >= nearest)) continue;
        found = knob;
        nearest = at.z;
    }
    return found;
}

Scene dragged(const Scene& scene, const Knob& knob, const CameraView& view, glm::dvec2 pixel) {
    Scene result = scene;
    const Ray<World> ray = view.ray(pixel);
    if (knob.what == Knob::What::Slice) {
        if (!result.slice) return result;
        // The point of the knob's line that is nearest to the pixel's ray.
        const glm::dvec3 u = knob.along.xyz, d = glm::normalize(ray.direction.xyz), w = knob.at.xyz - ray.origin.xyz;
        const double uu = glm::dot(u, u), ud = glm::dot(u, d), determinant = uu - ud * ud;
        if (determinant < 1e-3 * uu) return result;  // it points at the eye
        const double by = (ud * glm::dot(d, w) - glm::dot(u, w)) / determinant;
        double most = 1e9;
        if (const FormulaSurface* formula = std::get_if<FormulaSurface>(&scene.surface)) most = formula->bound;
        result.slice->at = std::clamp(std::round(100.0 * (result.slice->at + by)) / 100.0, -most, most) + 0.0;
        return result;
    }
    if (!result.ray) return result;
    const glm::dvec3 n = glm::cross(view.right().xyz, view.up().xyz);
    const double across = glm::dot(ray.direction.xyz, n);
    if (std::abs(across) < 1e-9) return result;
    const double t = glm::dot(knob.at.xyz - ray.origin.xyz, n) / across;
    const glm::dvec3 there = in_hundredths(ray.origin.xyz + t * ray.direction.xyz);
    (knob.what == Knob::What::RayFrom ? result.ray->from : result.ray->toward) =
        Point<World>{glm::clamp(there, glm::dvec3(-1e6), glm::dvec3(1e6))};
    return result;
}

}  // namespace normalscope

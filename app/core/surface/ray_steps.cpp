#include "core/surface/ray_steps.h"

#include "core/math/transform.h"
#include "core/surface/surface_probe.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace normalscope {

std::array<Point<World>, 2> aim(const AimedRay& ray, const Camera& camera, const CameraView& view) {
    const Point<World> target = ray.toward.value_or(camera.target);
    // Beside the camera: from the eye itself it would be seen end on.
    const double reach = 0.85 * camera.reach();
    const Vector<World> back{glm::normalize(view.eye().xyz - camera.target.xyz)};
    const Point<World> from =
        camera.target + -0.75 * reach * view.right() + 0.45 * reach * view.up() + 0.5 * reach * back;
    return {ray.from.value_or(from), target};
}

RaySteps ray_steps(const Scene& scene, const Surface& surface, const Transform<World, Object>& world_from_object,
                   const CameraView& view) {
    RaySteps s;
    const auto [from, target] = aim(scene.ray.value_or(AimedRay{}), scene.camera, view);
    const double length = glm::length((target - from).xyz);
    s.world = {from, length > 0.0 ? (1.0 / length) * (target - from) : Vector<World>{{0.0, 0.0, -1.0}}};
    s.toward_light = scene.light.vector();
    const auto ends = [&](RaySteps::End end, int step) {
        s.end = end;
        s.last_step = step;
        return s;
    };

    const bool affine = is_affine(world_from_object.matrix());
    const auto object_from_world = affine ? world_from_object.inverse() : std::nullopt;
    if (object_from_world) s.object = {(*object_from_world)(s.world.origin), (*object_from_world)(s.world.direction)};
    const auto hit = first_hit(surface, world_from_object, s.world);
    if (hit) {
        s.t = hit->t;
        s.point_world = s.world.origin + hit->t * s.world.direction;
    }
    if (!s.object) return ends(affine ? RaySteps::End::NoInverse : RaySteps::End::NotAffine, 0);
    if (!hit) return ends(RaySteps::End::Misses, 1);

    s.point = s.object->origin + *s.t * s.object->direction;
    const double stretch = glm::length(s.object->direction.xyz);
    s.t_if_normalised = *s.t * stretch;
    s.point_if_normalised = s.world.origin + *s.t_if_normalised * s.world.direction;
    Normal<Object> gradient = hit->probe.normal;
    if (surface.implicit) {
        const formulas::Sample sample = surface.implicit->written_at(*s.point);
        s.f = sample.value;
        // Where it is too small or too large for a number, its direction is that of another.
        const double square = glm::dot(sample.gradient, sample.gradient);
        gradient = {std::isnormal(square) ? sample.gradient : surface.implicit->at(*s.point).gradient};
    }
    if (!hit->probe.has_normal() || !std::isfinite(glm::length(gradient.xyz))) return ends(RaySteps::End::NoNormal, 3);
    s.gradient = gradient;
    s.normal = world_from_object(gradient);
    s.unit = Normal<World>{glm::normalize(s.normal->xyz)};
    s.brightness = dot(*s.unit, s.toward_light);
    const glm::dvec3 naive = transform_normal_naively(world_from_object, gradient).xyz;
    s.naive_brightness = glm::dot(glm::normalize(naive), s.toward_light.xyz);
    return s;
}

}  // namespace normalscope

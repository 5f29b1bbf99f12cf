#include "core/surface_probe.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace normalscope {

namespace {

// Of the bound. What is nearer to the surface than this was meant to lie on it.
constexpr double kNear = 0.05;
constexpr double kNeighbour = 0.02;

bool has_direction(const glm::dvec3& gradient) {
    const double length = glm::length(gradient);
    return std::isfinite(length) && length > 0.0;
}

// ∇f is as good as zero where it is small against what it is a little further away.
bool vanishes(const ImplicitSurface& surface, Point<Object> p, const glm::dvec3& gradient) {
    if (!has_direction(gradient)) return true;
    double around = 0.0;
    const double reach = kNeighbour * surface.source().bound;
    for (glm::length_t i = 0; i < 3; ++i)
        for (const double side : {-reach, reach}) {
            glm::dvec3 q = p.xyz;
            q[i] += side;
            const double length = glm::length(surface.at({q}).gradient);
            if (std::isfinite(length)) around = std::max(around, length);
        }
    return glm::length(gradient) < 1e-6 * around;
}

// Towards the corners of a cube in turn, until there is a point of the surface with a normal of its own.
std::optional<Probe> borrowed(const ImplicitSurface& surface, Point<Object> p) {
    const double reach = kNeighbour * surface.source().bound;
    for (int k = 0; k < 26; ++k) {
        const int code = k < 13 ? k : k + 1;  // 13 is no direction at all
        const glm::dvec3 toward(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
        const auto q = surface.onto_surface({p.xyz + reach * glm::normalize(toward)}, reach);
        if (!q || glm::distance(q->xyz, p.xyz) < 0.1 * reach) continue;
        const glm::dvec3 gradient = surface.at(*q).gradient;
        if (vanishes(surface, *q, gradient)) continue;
        Probe probe = probe_with(p, {gradient});
        probe.borrowed_from = *q;
        return probe;
    }
    return std::nullopt;
}

std::optional<Probe> nearest_on(const ImplicitSurface& surface, const Mesh& mesh, Point<Object> p) {
    const double reach = kNear * surface.source().bound;
    if (const auto on = surface.onto_surface(p, reach); on && surface.inside_clip(on->xyz))
        return probe_on(surface, *on);
    if (surface.at(p).value == 0.0) return probe_on(surface, p);
    const auto near = nearest_probe(mesh, p);
    if (!near) return std::nullopt;
    const auto on = surface.onto_surface(near->point, reach);
    return on ? probe_on(surface, *on) : near;
}

}  // namespace

std::optional<Probe> probe_on(const ImplicitSurface& surface, Point<Object> p) {
    const glm::dvec3 gradient = surface.at(p).gradient;
    return vanishes(surface, p, gradient) ? borrowed(surface, p) : probe_with(p, {gradient});
}

std::optional<SurfaceHit> first_hit(const Surface& surface, const Transform<World, Object>& worldFromObject,
                                    const Ray<World>& ray) {
    const auto objectFromWorld = surface.implicit ? worldFromObject.inverse() : std::nullopt;
    if (!objectFromWorld) return first_hit(surface.mesh, worldFromObject, ray);
    // Point and direction go to object space unchanged in length: t is the same in both.
    const Ray<Object> object_ray{(*objectFromWorld)(ray.origin), (*objectFromWorld)(ray.direction)};
    const auto t = surface.implicit->first_hit(object_ray);
    if (!t) return std::nullopt;
    const auto probe = probe_on(*surface.implicit, object_ray.origin + *t * object_ray.direction);
    return probe ? std::optional(SurfaceHit{*probe, *t}) : std::nullopt;
}

std::optional<Probe> nearest_probe(const Surface& surface, Point<Object> p) {
    return surface.implicit ? nearest_on(*surface.implicit, surface.mesh, p) : nearest_probe(surface.mesh, p);
}

std::optional<Probe> probe_in_view(const Surface& surface, const Transform<World, Object>& worldFromObject,
                                   const CameraView& view, glm::dvec2 pixel) {
    if (!surface.implicit) return probe_in_view(surface.mesh, worldFromObject, view, pixel);
    if (const auto hit = first_hit(surface, worldFromObject, view.ray(pixel))) return hit->probe;
    const auto near = probe_in_view(surface.mesh, worldFromObject, view, pixel);
    return near ? nearest_on(*surface.implicit, surface.mesh, near->point) : std::nullopt;
}

}  // namespace normalscope

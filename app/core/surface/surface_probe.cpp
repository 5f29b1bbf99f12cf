#include "core/surface/surface_probe.h"

#include "core/program/zero_crossing.h"
#include "core/surface/singular_point.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

// Of the bound. What is nearer to the surface than this was meant to lie on it.
constexpr double kNear = 0.05;
constexpr double kAround = 0.02;

// A step from where f is but rounding would lead anywhere. Held against the smaller side along each axis: beside an
// exponential's huge values all else would look like rounding.
bool rounds_to_zero(const ImplicitSurface& surface, const glm::dvec3& p) {
    double around = 0.0;
    for (glm::length_t i = 0; i < 3; ++i) {
        double smaller = formulas::kInfinity;
        for (const double side : {-kAround, kAround}) {
            glm::dvec3 q = p;
            q[i] += side * surface.source().bound;
            const double f = std::abs(surface.at({q}).value);
            if (std::isfinite(f)) smaller = std::min(smaller, f);
        }
        if (std::isfinite(smaller)) around = std::max(around, smaller);
    }
    const double f = std::abs(surface.at({p}).value);
    return f <= 1e-13 * around && (f > 0.0 || surface.lies_on(p));
}

// Where f changes its sign near a point of a mesh, along the normal there.
std::optional<Point<Object>> crossing_near(const ImplicitSurface& surface, const Probe& near, double reach) {
    const double f = surface.at(near.point).value;
    for (int step = 20; step >= 0; --step)
        for (const double side : {reach, -reach}) {
            const glm::dvec3 p = near.point.xyz, q = p + std::ldexp(side, -step) * near.normal.xyz;
            const double g = surface.at({q}).value;
            if (std::isnan(f) || std::isnan(g) || (f < 0.0) == (g < 0.0)) continue;
            if (const auto s = formulas::zero_between(surface.program(), p, q))
                return Point<Object>{glm::mix(p, q, *s)};
        }
    return std::nullopt;
}

const TriangleTree* tree_of(const Surface& surface) {
    return surface.tree ? surface.tree->for_one(surface.mesh) : nullptr;
}

std::optional<Probe> nearest_on(const Surface& all, Point<Object> p, const std::optional<Direction<Object>>& borrow) {
    const ImplicitSurface& surface = *all.implicit;
    if (surface.inside_clip(p.xyz) && rounds_to_zero(surface, p.xyz)) return probe_on(surface, p, borrow);
    const double reach = kNear * surface.source().bound;
    if (const auto on = surface.onto_surface(p, reach); on && surface.inside_clip(on->xyz))
        return probe_on(surface, *on, borrow);
    if (surface.inside_clip(p.xyz) && surface.at(p).value == 0.0 && surface.lies_on(p.xyz))
        return probe_on(surface, p, borrow);
    const auto near = nearest_probe(all.mesh, p, tree_of(all));
    if (!near) {  // only rays find it
        const auto on = surface.onto_surface(p, 2.0 * surface.source().bound);
        return on && surface.inside_clip(on->xyz) ? std::optional(probe_on(surface, *on, borrow)) : std::nullopt;
    }
    auto on = surface.onto_surface(near->point, reach);
    if (!on) on = crossing_near(surface, *near, reach);
    return on ? std::optional(probe_on(surface, *on, borrow)) : std::nullopt;
}

// Under an M that is not affine t is another one in object space, and a ray may come back from infinity there: the mesh
// tells where the surface is met, all but exactly.
std::optional<SurfaceHit> hit_beside_mesh(const Surface& surface, const Transform<World, Object>& m,
                                          const Ray<World>& ray) {
    std::optional<SurfaceHit> hit = first_hit(surface.mesh, m, ray, tree_of(surface));
    if (!hit) return std::nullopt;
    const auto on = surface.implicit->onto_surface(hit->probe.point, kNear * surface.implicit->source().bound);
    if (!on || !m.reaches(*on)) return hit;
    hit->probe = probe_on(*surface.implicit, *on);
    hit->t = dot(m(*on) - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
    return hit;
}

// Newton's steps come as near to 0 as 1e-161 where 0 is meant, and never there.
Point<Object> tidied(const ImplicitSurface& surface, Point<Object> p) {
    Point<Object> tidy = p;
    for (glm::length_t i = 0; i < 3; ++i)
        if (std::abs(p.xyz[i]) < 1e-15 * surface.source().bound) tidy.xyz[i] = 0.0;
    return std::abs(surface.at(tidy).value) <= std::abs(surface.at(p).value) ? tidy : p;
}

}  // namespace

Probe probe_on(const ImplicitSurface& surface, Point<Object> anywhere, const std::optional<Direction<Object>>& borrow) {
    const Point<Object> p = tidied(surface, anywhere);
    if (!is_singular(surface, p)) return probe_with(p, {surface.at(p).gradient});
    if (borrow)
        if (const auto neighbour = lender(surface, p, *borrow)) {
            Probe probe = probe_with(p, neighbour->normal);
            probe.singular = true;
            probe.borrowed_from = neighbour->point;
            return probe;
        }
    Probe probe;
    probe.point = p;
    probe.singular = true;
    return probe;
}

void prepare_for_many_hits(const Surface& surface, const Transform<World, Object>& world_from_object) {
    const bool by_mesh = !surface.implicit || !world_from_object.affine() || !world_from_object.inverse();
    if (by_mesh && surface.tree) surface.tree->for_many(surface.mesh);
}

std::optional<SurfaceHit> first_hit(const Surface& surface, const Transform<World, Object>& world_from_object,
                                    const Ray<World>& ray) {
    if (surface.implicit && !world_from_object.affine()) return hit_beside_mesh(surface, world_from_object, ray);
    const auto object_from_world = surface.implicit ? world_from_object.inverse() : std::nullopt;
    if (!object_from_world) return first_hit(surface.mesh, world_from_object, ray, tree_of(surface));
    // Point and direction go to object space unchanged in length: t is the same in both.
    const Ray<Object> object_ray{(*object_from_world)(ray.origin), (*object_from_world)(ray.direction)};
    const auto t = surface.implicit->first_hit(object_ray);
    if (!t) return std::nullopt;
    return SurfaceHit{probe_on(*surface.implicit, object_ray.origin + *t * object_ray.direction), *t};
}

std::optional<Probe> nearest_probe(const Surface& surface, Point<Object> p,
                                   const std::optional<Direction<Object>>& borrow) {
    return surface.implicit ? nearest_on(surface, p, borrow) : nearest_probe(surface.mesh, p, tree_of(surface));
}

std::optional<std::size_t> nearest_triangle(const Surface& surface, Point<Object> p) {
    return nearest_triangle(surface.mesh, p, tree_of(surface));
}

std::optional<Probe> probe_in_view(const Surface& surface, const Transform<World, Object>& world_from_object,
                                   const CameraView& view, glm::dvec2 pixel,
                                   const std::optional<Direction<Object>>& borrow) {
    if (!surface.implicit) return probe_in_view(surface.mesh, world_from_object, view, pixel, tree_of(surface));
    if (const auto hit = first_hit(surface, world_from_object, view.ray(pixel)))
        return hit->probe.singular ? probe_on(*surface.implicit, hit->probe.point, borrow) : hit->probe;
    const auto near = probe_in_view(surface.mesh, world_from_object, view, pixel, tree_of(surface));
    return near ? nearest_on(surface, near->point, borrow) : std::nullopt;
}

}  // namespace normalscope

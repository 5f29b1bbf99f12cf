#pragma once

#include "core/surface/mesh_probe.h"
#include "core/surface/surface.h"

namespace normalscope {

// What mesh_probe.h finds on a mesh, found on whatever the surface is: a formula's on f = 0 itself, with ∇f for its normal.

/// To be called before very many of them with the same M.
void prepare_for_many_hits(const Surface& surface, const Transform<World, Object>& world_from_object);
std::optional<SurfaceHit> first_hit(const Surface& surface, const Transform<World, Object>& world_from_object,
                                    const Ray<World>& ray);
std::optional<Probe> nearest_probe(const Surface& surface, Point<Object> p,
                                   const std::optional<Direction<Object>>& borrow = {});
/// Of its mesh.
std::optional<std::size_t> nearest_triangle(const Surface& surface, Point<Object> p);
std::optional<Probe> probe_in_view(const Surface& surface, const Transform<World, Object>& world_from_object,
                                   const CameraView& view, glm::dvec2 pixel,
                                   const std::optional<Direction<Object>>& borrow = {});

/// The probe at a point of f = 0. Where ∇f is zero or does not exist there is no normal, unless one is to be borrowed from
/// a neighbour on the surface, and there is one that has its own.
Probe probe_on(const ImplicitSurface& surface, Point<Object> p, const std::optional<Direction<Object>>& borrow = {});

}  // namespace normalscope

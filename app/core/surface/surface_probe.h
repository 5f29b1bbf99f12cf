#pragma once

#include "core/surface/probe.h"
#include "core/surface/surface.h"

namespace normalscope {

// What probe.h finds on a mesh, found on whatever the surface is: a formula's on f = 0 itself, with ∇f for its normal.

std::optional<SurfaceHit> first_hit(const Surface& surface, const Transform<World, Object>& world_from_object,
                                    const Ray<World>& ray);
std::optional<Probe> nearest_probe(const Surface& surface, Point<Object> p,
                                   const std::optional<Direction<Object>>& borrow = {});
std::optional<Probe> probe_in_view(const Surface& surface, const Transform<World, Object>& world_from_object,
                                   const CameraView& view, glm::dvec2 pixel,
                                   const std::optional<Direction<Object>>& borrow = {});

/// The probe at a point of f = 0. Where ∇f is zero or does not exist there is no normal, unless one is to be borrowed from
/// a neighbour on the surface, and there is one that has its own.
Probe probe_on(const ImplicitSurface& surface, Point<Object> p, const std::optional<Direction<Object>>& borrow = {});

}  // namespace normalscope

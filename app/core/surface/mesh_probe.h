#pragma once

#include "core/surface/probe.h"
#include "core/surface/triangle_tree.h"

namespace normalscope {

// What is found on a mesh: by its tree or, without one, by looking at every triangle. The answer is the same.

struct SurfaceHit {
    Probe probe;
    double t = 0.0;  ///< along the ray, in lengths of its direction
};

/// The first point of the surface that the ray meets, from either side.
std::optional<SurfaceHit> first_hit(const Mesh& mesh, const Transform<World, Object>& world_from_object,
                                    const Ray<World>& ray, const TriangleTree* tree = nullptr);

/// The index of the triangle that is nearest to `p`; empty only for a mesh without triangles.
std::optional<std::size_t> nearest_triangle(const Mesh& mesh, Point<Object> p, const TriangleTree* tree = nullptr);

/// The point of the surface that is nearest to `p`; empty only for a mesh without triangles.
std::optional<Probe> nearest_probe(const Mesh& mesh, Point<Object> p, const TriangleTree* tree = nullptr);

/// The point of the surface that the camera sees nearest the given pixel: the hit of its ray or, if that misses, the
/// nearest point of the silhouette. Empty where nothing lies before the camera.
std::optional<Probe> probe_in_view(const Mesh& mesh, const Transform<World, Object>& world_from_object,
                                   const CameraView& view, glm::dvec2 pixel, const TriangleTree* tree = nullptr);

}  // namespace normalscope

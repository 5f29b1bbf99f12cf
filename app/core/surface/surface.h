#pragma once

#include "core/mesh/mesh.h"
#include "core/scene/mistakes.h"
#include "core/scene/scene.h"
#include "core/surface/implicit_surface.h"
#include "core/surface/triangle_tree.h"

#include <memory>
#include <vector>

namespace normalscope {

/// The surface as it is drawn: its mesh with the normals in use, and the places of its arrows. Object space, immutable,
/// shared by whoever draws or measures it.
struct Surface {
    Mesh mesh;
    /// What a formula's mesh comes from, and what is drawn in its place; empty for shapes and mesh files.
    std::shared_ptr<const ImplicitSurface> implicit;
    std::vector<Site> arrows;
    double area = 0.0;
    glm::dvec3 extent{0.0};              ///< the largest |x|, |y| and |z|
    std::shared_ptr<TreeInTime> tree{};  ///< over the mesh's triangles; none: every one is looked at, each time
};

/// Keeps the last surface, and what it was made from, so that only what changed is made again: a mesh file is read
/// once, whatever is done to the arrows.
class SurfaceCache {
public:
    /// The scene's surface. Throws InputError, as load_mesh and make_shape do; the last surface is kept then.
    /// When asked to stop, it may throw Stopped (core/surface/stopped.h), and the last surface is kept as well.
    std::shared_ptr<const Surface> get(const Scene& scene, const Stop& stop = {});
    /// Whether get() has next to nothing to do: the mesh is there.
    bool has_mesh_of(const Scene& scene) const { return mesh_ && mesh_source_ == scene.surface; }
    /// What the last surface was made from; only where there is one.
    const SurfaceSource& source() const { return surface_source_; }
    bool empty() const { return !surface_; }

private:
    std::shared_ptr<const Mesh> mesh_;
    std::shared_ptr<const ImplicitSurface> implicit_;
    SurfaceSource mesh_source_;
    std::shared_ptr<TreeInTime> tree_;
    std::shared_ptr<const Surface> surface_;
    SurfaceSource surface_source_;
    Arrows surface_arrows_;
};

/// The same surface with every face's own normal on its own vertices.
Mesh flat_shaded(const Mesh& mesh);

/// How far the naive rule is off over the normals of a surface as drawn.
struct ErrorStatistics {
    double worst_degrees = 0.0;
    double mean_degrees = 0.0;  ///< by area, before M
    Point<Object> at;           ///< where the worst one is
};

/// Empty where the inverse transpose does not exist, or the surface has no normal.
std::optional<ErrorStatistics> error_statistics(const Mesh& mesh, const NormalMatrices& matrices);

/// The same for another map in the naive rule's place, such as a scene's mistake, and any M: of what has an image, and held
/// against the normal at each place. Empty where M has no inverse.
std::optional<ErrorStatistics> error_statistics(const Mesh& mesh, const NormalMap& naive,
                                                const Transform<World, Object>& world_from_object);

/// The angle between the naive and the true image of `n`; empty where either does not exist.
std::optional<double> error_degrees(const NormalMatrices& matrices, Normal<Object> n);

}  // namespace normalscope

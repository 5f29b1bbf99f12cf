#pragma once

#include "core/math/camera.h"
#include "core/math/transform.h"
#include "core/mesh/mesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <vector>

namespace normalscope {

/// The mesh in world space, as one view shows it.
struct SeenMesh {
    const Mesh& mesh;
    const Transform<World, Object>& m;
    const CameraView& view;
    std::vector<glm::dvec3> world;
    std::vector<bool> drawn;  ///< vertices that have an image
    std::vector<bool> front;  ///< triangles that turn as those at the front do

    bool draws(const glm::uvec3& t) const { return drawn[t.x] && drawn[t.y] && drawn[t.z]; }
};

/// Part of a line as one draws it by hand, in world space.
struct MeshLine {
    std::array<glm::dvec3, 2> ends;
    glm::dvec3 outward{0.0};  ///< of length 1; zero where the mesh has no normal
};

enum class Outline {
    ByFaces,   ///< along the mesh's edges, where a front meets a back
    ByNormals  ///< through its triangles, where the normals, which are those of a smooth surface, turn away
};

/// The outline, the rims and the sharp edges, seen or not.
std::vector<MeshLine> mesh_lines(const SeenMesh& seen, Outline outline);

}  // namespace normalscope

#pragma once

#include "core/math/transform.h"
#include "core/mesh/mesh.h"
#include "core/scene/mistakes.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <span>

namespace normalscope {

/// n · t over a whole surface: for each map, the largest |cos| of the angle between a normal that it has sent to world
/// space and two tangents at right angles that `tangents` has sent there. 0 but for rounding where the map keeps normals
/// perpendicular; empty where there is no map, or nothing to measure. `normals` are of unit length in object space, or zero where there is none.
/// What is sent to zero does not count. Works in blocks, on several threads where there are many.
ByRule<std::optional<double>> worst_dots(std::span<const glm::dvec3> normals,
                                         const ByRule<std::optional<NormalMap>>& maps, const glm::dmat3& tangents);

/// The same under an M that need not be affine, which sends tangents somewhere else at each place: of the vertices that
/// have an image.
ByRule<std::optional<double>> worst_dots(const Mesh& mesh, const ByRule<std::optional<NormalMap>>& maps,
                                         const Transform<World, Object>& world_from_object);

}  // namespace normalscope

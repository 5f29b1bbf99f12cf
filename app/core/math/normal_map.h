#pragma once

#include "core/math/space.h"

#include <glm/mat4x4.hpp>

namespace normalscope {

/// How a program sends normals to world space and what it does about their length: the first three numbers of
/// matrix · (n, w), then made of unit length at the vertices, at each pixel, or not at all.
struct NormalMap {
    enum class UnitLength { No, WithoutW, WithW };

    glm::dmat4 matrix{1.0};
    double w = 0.0;
    UnitLength at_vertices = UnitLength::No;
    bool at_pixels = true;

    Normal<World> operator()(Normal<Object> n) const { return {glm::dvec3(matrix * glm::dvec4(n.xyz, w))}; }
    friend bool operator==(const NormalMap&, const NormalMap&) = default;
};

}  // namespace normalscope

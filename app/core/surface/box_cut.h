#pragma once

#include "core/surface/implicit_surface.h"

#include <vector>

namespace normalscope {

/// Cuts triangles along the formula's cube: what lies beyond is left out, and where an edge leaves the cube a new vertex
/// comes to lie on its face and on f = 0. New vertices are added at the end; old ones stay, used or not.
void cut_to_box(const ImplicitSurface& surface, std::vector<glm::dvec3>& positions, std::vector<glm::uvec3>& triangles);

}  // namespace normalscope

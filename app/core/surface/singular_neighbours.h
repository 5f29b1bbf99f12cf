#pragma once

#include "core/mesh/mesh.h"
#include "core/surface/implicit_surface.h"

#include <vector>

namespace normalscope {

/// Of the ball or cube: the radius of a sphere so small that the normals on it are as good as limits.
inline constexpr double kAsGoodAsLimits = 1e-3;

using SiteCurves = std::vector<std::vector<Site>>;

/// Where the surface meets a small sphere about a singular point, curve by curve in order. Without what has no normal of its own,
/// as where two sheets cross; where f only touches 0, as a square does, a point on either side of the sheet. The last few are kept.
SiteCurves singular_neighbours(const ImplicitSurface& surface, Point<Object> p, double radius);

}  // namespace normalscope

#pragma once

#include "core/surface/implicit_surface.h"

namespace normalscope {

/// Triangles between the points where a grid of parallel rays, `cells` a side, first enters and last leaves the surface: for
/// sheets so thin that no grid of points has one within. Empty where too few rays meet it, or only touch it. Throws Stopped
/// (core/surface/stopped.h).
Mesh ray_mesh(const ImplicitSurface& surface, const formulas::Box& box, int cells, const Stop& stop);

}  // namespace normalscope

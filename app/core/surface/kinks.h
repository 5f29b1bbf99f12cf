#pragma once

#include "core/mesh/mesh.h"
#include "core/surface/implicit_surface.h"

namespace normalscope {

/// The surface's mesh with edges where f has a kink, as max(x, y) has one: each triangle across a kink is cut along it,
/// with vertices of their own on either side. Where the surface only bends, however sharply, the mesh stays as it is.
Mesh cut_at_kinks(Mesh mesh, const ImplicitSurface& surface);

}  // namespace normalscope

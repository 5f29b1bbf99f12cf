#pragma once

#include "core/mesh/mesh.h"
#include "core/scene/scene.h"

namespace normalscope {

/// A built-in shape with exact normals, `resolution` segments around; vertices come coarse to fine.
/// Throws InputError for a resolution outside 3 … 512.
Mesh make_shape(const ShapeSurface& shape);

}  // namespace normalscope

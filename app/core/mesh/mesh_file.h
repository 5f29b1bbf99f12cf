#pragma once

#include "core/mesh/mesh.h"

#include <filesystem>

namespace normalscope {

/// Reads an .obj, .ply or .stl file (the ending decides, in any case), triangulates its polygons, takes normals from
/// the file or computes them area-weighted, sharp at creases (`note` says so), and fits the result to the unit sphere.
/// Throws InputError, one line, for a file that cannot be read, is no such mesh, or has no usable face.
Mesh load_mesh(const std::filesystem::path& file);

}  // namespace normalscope

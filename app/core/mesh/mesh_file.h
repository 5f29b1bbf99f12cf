#pragma once

#include "core/mesh/mesh.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// The endings of the mesh formats that can be read, such as ".obj".
std::vector<std::string_view> mesh_endings();
/// The same in words, such as ".obj, .ply or .stl".
std::string mesh_endings_in_words(std::string_view between = ", ", std::string_view before_last = ", ");

/// Whether the file's ending is a mesh's, in any case.
bool is_mesh_file(const std::filesystem::path& file);

/// Whether it gives what it holds only once, as a pipe does: whoever opens it again would wait for ever.
bool gives_once(const std::filesystem::path& file);

/// Reads a mesh file (the ending decides, in any case), triangulates its polygons, takes normals from the file or computes
/// them area-weighted, sharp at creases (`notes` say so), and fits the result to the unit sphere.
/// Throws InputError, one line, for a file that cannot be read, is no such mesh, has no usable face, or gives_once() and
/// has been read.
Mesh load_mesh(const std::filesystem::path& file);

}  // namespace normalscope

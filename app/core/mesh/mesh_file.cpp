#include "core/mesh/mesh_file.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/polygons.h"

#include <algorithm>
#include <cctype>

namespace normalscope {

namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;  // some 25 million triangles

}  // namespace

Mesh load_mesh(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto reader = ending == ".obj"   ? read_obj
                        : ending == ".ply" ? read_ply
                        : ending == ".stl" ? read_stl
                                           : nullptr;
    if (!reader) throw InputError(name + ": its ending names no mesh format; a mesh ends in .obj, .ply or .stl");
    const std::string bytes = read_file(file, kLargestFile);
    if (bytes.empty()) throw InputError(name + ": is empty; export the mesh anew");
    return mesh_of(reader(bytes, name), name);
}

}  // namespace normalscope

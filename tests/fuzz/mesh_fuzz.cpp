// Any bytes as a mesh: the first one says as what (o, p or s, as .obj, .ply and .stl), the rest is the file.

#include "core/base/error.h"
#include "core/mesh/polygons.h"
#include "core/surface/surface.h"
#include "fuzz.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace normalscope::fuzz {

namespace {

void check(const Mesh& mesh) {
    require(!mesh.triangles.empty(), "a mesh without a triangle");
    require(mesh.positions.size() == mesh.normals.size(), "a vertex without a normal");
    for (const glm::uvec3& t : mesh.triangles)
        require(glm::max(glm::max(t.x, t.y), t.z) < mesh.positions.size(), "a corner that is no vertex");
    for (const glm::dvec3& p : mesh.positions)
        require(glm::length(p) <= 1.0 + 1e-9, "a point beyond the unit sphere, or none");
    for (const glm::dvec3& n : mesh.normals) {
        const double length = glm::length(n);
        require(length == 0.0 || std::abs(length - 1.0) < 1e-9, "a normal that is not of unit length");
    }
    require(std::isfinite(surface_area(mesh)), "an area that is none");
}

}  // namespace

void check(std::string_view bytes) {
    if (bytes.empty()) return;
    const std::string_view file = bytes.substr(1);
    try {
        switch (bytes[0]) {
            case 'o': check(mesh_of(read_obj(file, "m.obj"), "m.obj")); break;
            case 'p': check(mesh_of(read_ply(file, "m.ply"), "m.ply")); break;
            case 's': check(mesh_of(read_stl(file, "m.stl"), "m.stl")); break;
            default: break;
        }
    } catch (const InputError& e) {
        require(std::string_view(e.what()).find('\n') == std::string_view::npos, "an error is not one line");
    }
}

std::vector<std::string_view> words() {
    return {"o",
            "p",
            "s",
            "\n",
            " ",
            "v 0 0 0\n",
            "v 1 0 0\n",
            "v 0 1 0\n",
            "vn 0 0 1\n",
            "f 1 2 3\n",
            "f 1//1 2//1 3//1\n",
            "f -1 -2 -3\n",
            "f 1 2 3 4 5 6\n",
            "4000000000",
            "-1",
            "1e308",
            "nan",
            "0",
            "1e-300",
            "ply\nformat ascii 1.0\n",
            "format binary_little_endian 1.0\n",
            "format binary_big_endian 1.0\n",
            "element vertex 4000000000\n",
            "element vertex 3\n",
            "element face 1\n",
            "property float x\n",
            "property list uchar int vertex_indices\n",
            "property list int int vertex_indices\n",
            "property double nx\n",
            "element tristrips 1\n",
            "property list char short vertex_index\n",
            "element user 2\n",
            "\r",
            "\\\n",
            "\xEF\xBB\xBF",
            "0 1 2 -1 3 ",
            "end_header\n",
            "solid x\n",
            "ENDSOLID\n",
            "facet normal 0 0 1\nouter loop\n",
            "vertex 1 0 0\n",
            "endloop\nendfacet\n",
            std::string_view("\xff\xff\xff\xff", 4),
            std::string_view("\0\0\0\0", 4)};
}

}  // namespace normalscope::fuzz

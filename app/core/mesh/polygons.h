#pragma once

// What a mesh file says, before it is a Mesh. Only the readers of mesh files include this.

#include "core/mesh/mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// Polygons as the files have them: each corner names a position and, maybe, a normal.
struct Polygons {
    struct Corner {
        std::int32_t position;
        std::int32_t normal;  ///< kNone where the file gives none
    };
    static constexpr std::int32_t kNone = -1;
    /// Faces one after the other. There are several blocks where several threads have read the file.
    struct Block {
        std::vector<Corner> corners;
        std::vector<std::uint32_t> sizes;  ///< corners of each face
    };

    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    std::vector<Block> faces;
    std::string_view lacking = "normals";  ///< what the note calls the normals that the file does not have
};

/// Readers check what the file's format demands. They throw InputError; `file` names the text in errors.
Polygons read_obj(std::string_view text, const std::string& file);
Polygons read_ply(std::string_view bytes, const std::string& file);
Polygons read_stl(std::string_view bytes, const std::string& file);

/// What assimp makes of bytes whose claims about sizes have been checked. Throws InputError with assimp's reason.
Polygons import_by_assimp(std::string_view bytes, const char* ending, const std::string& file);

/// Appends triangles (as places in `ring`) that cover the polygon, which may be concave and a little out of plane.
/// Throws InputError for a concave one with more corners than can be cut in reasonable time.
void triangulate(const std::vector<glm::dvec3>& ring, std::vector<glm::uvec3>& triangles);

/// The mesh: corners merged into vertices, polygons cut into triangles, normals completed, fitted to the unit sphere.
Mesh mesh_of(Polygons polygons, const std::string& file);

}  // namespace normalscope

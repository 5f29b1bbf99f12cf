#pragma once

// What a mesh file says, before it is a Mesh. Only the readers of mesh files include this.

#include "core/mesh/mesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
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
    static constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::max();
    /// Faces one after the other. There are several blocks where several threads have read the file.
    struct Block {
        std::vector<Corner> corners;
        std::vector<std::uint32_t> sizes;  ///< corners of each face
    };

    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    std::vector<Block> faces;
    std::string_view lacking = "normals";  ///< what the note calls the normals that the file does not have
    std::string note{};                    ///< what else the user should know of the file; empty if nothing
    /// The line of a face, counted from 0, as long as the text or file is there; none where lines mean nothing to a user.
    std::function<std::size_t(std::size_t face)> line_of_face{};
};

/// Readers check what the file's format demands. They throw InputError; `file` names the text in errors. An index of
/// Polygons::kNowhere is one that no file has.
Polygons read_obj(std::string_view text, const std::string& file);
/// The same piece by piece, so that a large file is never in memory as a whole: what the system takes to clear that.
Polygons read_obj_file(const std::filesystem::path& file, std::size_t largest);
Polygons read_ply(std::string_view bytes, const std::string& file);
Polygons read_stl(std::string_view bytes, const std::string& file);

/// Appends triangles (as places in `ring`) that cover the polygon, which may be concave and a little out of plane.
/// Throws InputError for a concave one with more corners than can be cut in reasonable time.
void triangulate(const std::vector<glm::dvec3>& ring, std::vector<glm::uvec3>& triangles);

/// The mesh: corners merged into vertices, polygons cut into triangles, normals completed, fitted to the unit sphere.
Mesh mesh_of(Polygons polygons, const std::string& file);

}  // namespace normalscope

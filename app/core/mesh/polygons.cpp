#include "core/mesh/polygons.h"

#include "core/base/beside.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mesh/closed_mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace normalscope {

namespace {

constexpr double kLargestCoordinate = 1e30;  // its square and cube are still far from overflow
constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();

void check_positions(const Polygons& polygons, const std::string& file) {
    for (std::size_t i = 0; i < polygons.positions.size(); ++i) {
        const glm::dvec3 size = glm::abs(polygons.positions[i]);
        if (size.x <= kLargestCoordinate && size.y <= kLargestCoordinate && size.z <= kLargestCoordinate) continue;
        throw InputError(file + ": vertex " + std::to_string(i + 1) +
                         " has a coordinate that is not a number or is beyond 1e30; repair or export the mesh anew");
    }
}

struct CornerKinds {
    bool any_normal = false, any_without = false;
    bool same_index = true;  // wherever there is a normal, it has the position's index
};

// A corner whose normal is not in the file is one without a normal.
CornerKinds check_corners(Polygons& polygons, const std::string& file) {
    // Unsigned, so that one comparison finds the negative ones too.
    const auto positions = static_cast<std::uint32_t>(polygons.positions.size());
    const auto normals = static_cast<std::uint32_t>(polygons.normals.size());
    CornerKinds kinds;
    const auto complain = [&](const Polygons::Block& block, std::size_t corner) {
        std::size_t face = 0, end = 0;
        for (const Polygons::Block& before : polygons.faces) {
            if (&before == &block) break;
            face += before.sizes.size();
        }
        for (const std::uint32_t size : block.sizes) {
            ++face;
            if ((end += size) > corner) break;
        }
        const std::string line =
            polygons.line_of_face ? "line " + std::to_string(polygons.line_of_face(face - 1)) + ": " : "";
        throw InputError(file + ": " + line + "face " + std::to_string(face) +
                         " refers to a vertex that does not exist (there are " + std::to_string(positions) +
                         "); repair or export the mesh anew");
    };
    for (Polygons::Block& block : polygons.faces)
        for (Polygons::Corner& c : block.corners) {
            if (static_cast<std::uint32_t>(c.position) >= positions)
                complain(block, static_cast<std::size_t>(&c - block.corners.data()));
            if (static_cast<std::uint32_t>(c.normal) >= normals) {
                c.normal = Polygons::kNone;
                kinds.any_without = true;
                continue;
            }
            kinds.any_normal = true;
            kinds.same_index = kinds.same_index && c.normal == c.position;
        }
    return kinds;
}

/// Gives every pair of a position and a normal that occurs a vertex of its own. A position's first pair is the vertex
/// of the position's index; further ones are appended, and each position chains its own.
class VertexMerger {
public:
    explicit VertexMerger(std::size_t positions) : chain_(positions, {kUnused, kUnset}), position_of_(positions) {
        for (std::size_t i = 0; i < positions; ++i) position_of_[i] = static_cast<std::uint32_t>(i);
    }
    std::uint32_t vertex(const Polygons::Corner& c) {
        auto at = static_cast<std::uint32_t>(c.position);
        if (chain_[at].normal == kUnused) chain_[at].normal = c.normal;
        while (chain_[at].normal != c.normal) {
            if (chain_[at].next == kUnset) {
                chain_[at].next = static_cast<std::uint32_t>(chain_.size());
                chain_.push_back({c.normal, kUnset});
                position_of_.push_back(static_cast<std::uint32_t>(c.position));
            }
            at = chain_[at].next;
        }
        return at;
    }
    std::size_t size() const { return chain_.size(); }
    std::uint32_t position_of(std::size_t vertex) const { return position_of_[vertex]; }
    std::int32_t normal_of(std::size_t vertex) const { return std::max(chain_[vertex].normal, Polygons::kNone); }

private:
    static constexpr std::int32_t kUnused = Polygons::kNone - 1;
    struct Link {
        std::int32_t normal;
        std::uint32_t next;
    };
    std::vector<Link> chain_;
    std::vector<std::uint32_t> position_of_;
};

// The corners' vertices (by `vertex_of`), cut into triangles; counts faces of less than three corners.
template <class VertexOf>
std::size_t cut_into_triangles(const Polygons& polygons, Mesh& mesh, VertexOf&& vertex_of) {
    std::size_t corners = 0, faces = 0, too_small = 0;
    for (const Polygons::Block& block : polygons.faces) corners += block.corners.size(), faces += block.sizes.size();
    const bool triangles_only = std::ranges::all_of(polygons.faces, [](const Polygons::Block& block) {
        return std::ranges::all_of(block.sizes, [](std::uint32_t size) { return size <= 3; });
    });
    mesh.triangles.reserve(corners > 2 * faces ? corners - 2 * faces : 0);
    std::vector<glm::dvec3> ring;
    std::vector<glm::uvec3> cut;
    std::uint32_t face = 0;
    for (const Polygons::Block& block : polygons.faces) {
        const Polygons::Corner* corner = block.corners.data();
        for (const std::uint32_t size : block.sizes) {
            if (size == 3) {
                mesh.triangles.emplace_back(vertex_of(corner[0]), vertex_of(corner[1]), vertex_of(corner[2]));
                if (!triangles_only) mesh.face_of_triangle.push_back(face);
            } else if (size > 3) {
                ring.clear();
                cut.clear();
                for (std::uint32_t i = 0; i < size; ++i)
                    ring.push_back(polygons.positions[static_cast<std::size_t>(corner[i].position)]);
                triangulate(ring, cut);
                for (const glm::uvec3& t : cut) {
                    mesh.triangles.emplace_back(vertex_of(corner[t.x]), vertex_of(corner[t.y]), vertex_of(corner[t.z]));
                    mesh.face_of_triangle.push_back(face);
                }
            } else {
                ++too_small;
            }
            if (size >= 3) ++face;
            corner += size;
        }
    }
    return too_small;
}

// Removes triangles without area (to rounding: a height of less than 1e-14 of the longest side) and renumbers the faces
// that are left.
std::size_t drop_flat_triangles(Mesh& mesh) {
    const bool faces = !mesh.face_of_triangle.empty();
    std::size_t kept = 0;
    std::uint32_t face = 0, last_face = kUnset;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        const glm::dvec3 ab = mesh.positions[t.y] - mesh.positions[t.x], ac = mesh.positions[t.z] - mesh.positions[t.x],
                         twice_area = glm::cross(ab, ac), bc = ac - ab;
        const double longest2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
        if (!(glm::dot(twice_area, twice_area) > 1e-28 * longest2 * longest2)) continue;
        mesh.triangles[kept] = t;
        if (faces) {
            if (last_face != kUnset && mesh.face_of_triangle[i] != last_face) ++face;
            last_face = mesh.face_of_triangle[i];
            mesh.face_of_triangle[kept] = face;
        }
        ++kept;
    }
    const std::size_t dropped = mesh.triangles.size() - kept;
    mesh.triangles.resize(kept);
    if (faces) mesh.face_of_triangle.resize(kept);
    return dropped;
}

// Vertices that no triangle uses would count for the mesh's size and get arrows.
void drop_unused_vertices(Mesh& mesh) {
    std::vector<std::uint32_t> place(mesh.positions.size(), kUnset);
    for (const glm::uvec3& t : mesh.triangles) place[t.x] = place[t.y] = place[t.z] = 0;
    std::uint32_t used = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (place[i] == kUnset) continue;
        mesh.positions[used] = mesh.positions[i];
        if (!mesh.normals.empty()) mesh.normals[used] = mesh.normals[i];
        place[i] = used++;
    }
    if (used == place.size()) return;
    mesh.positions.resize(used);
    if (!mesh.normals.empty()) mesh.normals.resize(used);
    for (glm::uvec3& t : mesh.triangles) t = {place[t.x], place[t.y], place[t.z]};
}

// Unit length; zero where there is no direction in it.
void normalise(std::vector<glm::dvec3>& normals) {
    for (glm::dvec3& n : normals) {
        const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
        const bool usable =
            largest > 0.0 && largest <= std::numeric_limits<double>::max() && !std::isnan(n.x + n.y + n.z);
        // By the largest first: the square of a tiny or huge component would under- or overflow.
        n = usable ? glm::normalize(n / largest) : glm::dvec3(0.0);
    }
}

// Those of the file as far as it has them, and whether it is closed.
void set_normals(Mesh& mesh, const CornerKinds& kinds, const std::string& short_name, std::string_view lacking) {
    Beside<bool> closed = beside([&mesh] { return is_closed(mesh); });
    mesh.normal_source = kinds.any_normal ? NormalSource::File : NormalSource::Computed;
    normalise(mesh.normals);
    const auto missing = kinds.any_normal ? static_cast<std::size_t>(std::ranges::count(mesh.normals, glm::dvec3(0.0)))
                                          : mesh.positions.size();
    if (missing > 0) {
        const std::string what =
            kinds.any_normal ? " lacks " + counted(missing, "usable normal") : " has no " + std::string(lacking);
        mesh.notes.push_back(short_name + what + ": computed, area-weighted");
        mesh.closed = closed.get();  // it reads what changes now
        if (complete_normals(mesh))
            mesh.notes.back() +=
                ", sharp where faces meet at more than " + std::to_string(std::lround(kCreaseDegrees)) + "°";
    }
    if (closed) mesh.closed = closed.get();
}

}  // namespace

Mesh mesh_of(Polygons polygons, const std::string& file) {
    const std::string short_name = std::filesystem::path(file).filename().string();
    check_positions(polygons, file);
    const CornerKinds kinds = check_corners(polygons, file);

    Mesh mesh;
    std::size_t flat = 0;
    try {
        if (!kinds.any_normal || (kinds.same_index && !kinds.any_without)) {
            flat = cut_into_triangles(polygons, mesh,
                                      [](const Polygons::Corner& c) { return static_cast<std::uint32_t>(c.position); });
            mesh.positions = std::move(polygons.positions);
            if (kinds.any_normal) {
                mesh.normals = std::move(polygons.normals);
                mesh.normals.resize(mesh.positions.size(), glm::dvec3(0.0));
            }
        } else {
            VertexMerger merger(polygons.positions.size());
            flat = cut_into_triangles(polygons, mesh, [&](const Polygons::Corner& c) { return merger.vertex(c); });
            for (std::size_t i = 0; i < merger.size(); ++i) {
                const std::int32_t normal = merger.normal_of(i);
                mesh.positions.push_back(polygons.positions[merger.position_of(i)]);
                mesh.normals.push_back(normal == Polygons::kNone ? glm::dvec3(0.0)
                                                                 : polygons.normals[static_cast<std::size_t>(normal)]);
            }
        }
    } catch (const InputError& e) {
        throw InputError(file, e.what());
    }
    if (mesh.triangles.empty())
        throw InputError(file, std::string("has no faces") + (mesh.positions.empty() ? "" : ", only points or lines") +
                                   "; export it as a surface");

    // The size that decides what is flat must not depend on the file's unit.
    drop_unused_vertices(mesh);
    fit_to_unit_sphere(mesh);
    const std::size_t dropped = drop_flat_triangles(mesh);
    if (mesh.triangles.empty())
        throw InputError(
            file, "all of its faces (" + std::to_string(dropped) + ") have no area; repair or export the mesh anew");
    if (dropped > 0) {
        drop_unused_vertices(mesh);
        fit_to_unit_sphere(mesh);
    }
    flat += dropped;

    set_normals(mesh, kinds, short_name, polygons.lacking);
    if (flat > 0) mesh.notes.push_back(short_name + ": " + counted(flat, "face") + " without area left out");
    if (!polygons.note.empty()) mesh.notes.push_back(short_name + ": " + polygons.note);
    return mesh;
}

}  // namespace normalscope

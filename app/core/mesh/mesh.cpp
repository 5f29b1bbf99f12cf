#include "core/mesh/mesh.h"

#include "core/base/disjoint_sets.h"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace normalscope {

namespace {

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

// Twice the triangle's area, along its normal.
glm::dvec3 area_vector(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3& a = mesh.positions[t.x];
    return glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
}

/// Points at least a radius apart, in a hashed grid whose cells are two radii wide: whoever is within the radius of a
/// place sits in one of the at most eight cells that a ball about it touches.
class SpacedPoints {
public:
    /// No point may be farther than `kFarthest` radii from the origin along any axis.
    static constexpr double kFarthest = 1e5;

    SpacedPoints(double radius, std::size_t most) : radius_(radius), heads_(std::bit_ceil(4 * most + 1), kNone) {
        points_.reserve(most);
        next_.reserve(most);
    }
    bool any_within_radius(const glm::dvec3& p) const {
        const glm::ivec3 low = cell(p - radius_), high = cell(p + radius_);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    // Points of other cells in the same slot do no harm: the distance decides.
                    for (std::uint32_t i = heads_[slot({x, y, z})]; i != kNone; i = next_[i])
                        if (glm::dot(points_[i] - p, points_[i] - p) < radius_ * radius_) return true;
        return false;
    }
    void add(const glm::dvec3& p) {
        std::uint32_t& head = heads_[slot(cell(p))];
        next_.push_back(head);
        head = static_cast<std::uint32_t>(points_.size());
        points_.push_back(p);
    }

private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    // Truncation is floor for what is positive, and much faster.
    glm::ivec3 cell(const glm::dvec3& p) const { return glm::ivec3(p / (2.0 * radius_) + kFarthest); }
    std::size_t slot(const glm::ivec3& c) const {  // Teschner et al., "Optimized spatial hashing", 2003
        const glm::uvec3 u(c);
        return (u.x * 73856093u ^ u.y * 19349663u ^ u.z * 83492791u) & (heads_.size() - 1);
    }

    double radius_;
    std::vector<std::uint32_t> heads_, next_;
    std::vector<glm::dvec3> points_;
};

}  // namespace

std::vector<glm::dvec3> area_weighted_normals(const std::vector<glm::dvec3>& positions,
                                              const std::vector<glm::uvec3>& triangles) {
    std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3& a = positions[t.x];
        const glm::dvec3 twice_area = glm::cross(positions[t.y] - a, positions[t.z] - a);
        normals[t.x] += twice_area;
        normals[t.y] += twice_area;
        normals[t.z] += twice_area;
    }
    for (glm::dvec3& n : normals) n = unit_or_zero(n);
    return normals;
}

namespace {

/// The corners that meet at each vertex, 3 · triangle + which: those of vertex v from starts[v] on.
struct CornersAtVertices {
    explicit CornersAtVertices(const Mesh& mesh)
        : starts(mesh.positions.size() + 1, 0), corners(3 * mesh.triangles.size()) {
        for (const glm::uvec3& t : mesh.triangles)
            for (int k = 0; k < 3; ++k) ++starts[t[k] + 1];
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
        for (std::uint32_t i = 0; i < corners.size(); ++i)
            corners[next[mesh.triangles[i / 3][static_cast<int>(i % 3)]]++] = i;
    }
    std::span<const std::uint32_t> at(std::size_t vertex) const {
        return std::span(corners).subspan(starts[vertex], starts[vertex + 1] - starts[vertex]);
    }

    std::vector<std::uint32_t> starts, corners;
};

// Which of a vertex' faces hang together across edges that are no creases.
DisjointSets parts_around(const Mesh& mesh, std::span<const std::uint32_t> corners,
                          std::span<const glm::dvec3> face_normals, double least_cosine) {
    struct Side {
        std::uint32_t other_end, face;  // the latter of the vertex' faces
    };
    std::vector<Side> sides;
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[corners[i] / 3];
        const auto k = static_cast<int>(corners[i] % 3);
        sides.push_back({t[(k + 1) % 3], i});
        sides.push_back({t[(k + 2) % 3], i});
    }
    std::ranges::sort(sides, {}, [](const Side& s) { return std::pair(s.other_end, s.face); });
    DisjointSets parts(corners.size());
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].other_end != sides[i - 1].other_end) continue;
        const std::uint32_t a = sides[i - 1].face, b = sides[i].face;
        if (glm::dot(face_normals[corners[a] / 3], face_normals[corners[b] / 3]) >= least_cosine) parts.join(a, b);
    }
    return parts;
}

// Gives each side of a crease a vertex of its own where the vertex has no normal.
void split_at_creases(Mesh& mesh) {
    const double least_cosine = std::cos(glm::radians(kCreaseDegrees)),
                 half = std::cos(glm::radians(kCreaseDegrees / 2));
    std::vector<glm::dvec3> face_normals(mesh.triangles.size());
    for (std::size_t i = 0; i < face_normals.size(); ++i)
        face_normals[i] = unit_or_zero(area_vector(mesh, mesh.triangles[i]));
    const CornersAtVertices around(mesh);
    for (std::size_t v = 0, count = mesh.positions.size(); v < count; ++v) {
        if (mesh.normals[v] != glm::dvec3(0.0)) continue;
        const std::span<const std::uint32_t> corners = around.at(v);
        // Where all lean less than half as much from their mean no two are apart: so it is nearly everywhere.
        glm::dvec3 sum(0.0);
        for (const std::uint32_t c : corners) sum += face_normals[c / 3];
        const glm::dvec3 mean = unit_or_zero(sum);
        if (std::ranges::all_of(corners, [&](std::uint32_t c) { return glm::dot(face_normals[c / 3], mean) >= half; }))
            continue;
        DisjointSets parts = parts_around(mesh, corners, face_normals, least_cosine);
        std::vector<std::uint32_t> vertex_of_part(corners.size(), static_cast<std::uint32_t>(v));
        for (std::uint32_t i = 0; i < corners.size(); ++i) {
            const std::uint32_t part = parts.of(i);
            if (part == 0) continue;
            if (part == i) {
                vertex_of_part[i] = static_cast<std::uint32_t>(mesh.positions.size());
                mesh.positions.push_back(glm::dvec3(mesh.positions[v]));
            }
            mesh.triangles[corners[i] / 3][static_cast<int>(corners[i] % 3)] = vertex_of_part[part];
        }
    }
}

}  // namespace

bool complete_normals(Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    mesh.normals.resize(count, glm::dvec3(0.0));
    split_at_creases(mesh);
    mesh.normals.resize(mesh.positions.size(), glm::dvec3(0.0));
    const std::vector<glm::dvec3> computed = area_weighted_normals(mesh.positions, mesh.triangles);
    for (std::size_t i = 0; i < computed.size(); ++i)
        if (mesh.normals[i] == glm::dvec3(0.0)) mesh.normals[i] = computed[i];
    return mesh.positions.size() > count;
}

std::vector<Site> face_sites(const Mesh& mesh) {
    std::vector<Site> sites;
    sites.reserve(mesh.face_count());
    const auto face_of = [&](std::size_t i) {
        return mesh.face_of_triangle.empty() ? i : std::size_t{mesh.face_of_triangle[i]};
    };
    for (std::size_t i = 0; i < mesh.triangles.size();) {
        glm::dvec3 weighted_centre(0.0), normal(0.0);
        double area = 0.0;
        for (const std::size_t face = face_of(i); i < mesh.triangles.size() && face_of(i) == face; ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            const glm::dvec3 twice_area = area_vector(mesh, t);
            const double weight = glm::length(twice_area);
            area += weight;
            normal += twice_area;
            weighted_centre += weight / 3.0 * (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]);
        }
        normal = unit_or_zero(normal);
        if (normal != glm::dvec3(0.0)) sites.push_back({{weighted_centre / area}, {normal}});
    }
    return sites;
}

std::vector<Site> vertex_sites(const Mesh& mesh) {
    std::vector<Site> sites;
    sites.reserve(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.normals[i] != glm::dvec3(0.0)) sites.push_back({{mesh.positions[i]}, {mesh.normals[i]}});
    return sites;
}

std::vector<Site> thinned(std::vector<Site> sites, std::size_t every, std::size_t limit, double surface_area) {
    if (every > 1) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < sites.size(); i += every) sites[kept++] = sites[i];
        sites.resize(kept);
    }
    if (sites.size() <= limit) return sites;
    if (limit == 0 || !(surface_area > 0.0)) return {};

    double farthest = 0.0;
    for (const Site& site : sites) {
        const glm::dvec3 size = glm::abs(site.point.xyz);
        farthest = std::max({farthest, size.x, size.y, size.z});
    }
    // A maximal set of points at least r apart covers each about 0.7 r² of the surface; grow r until it fits.
    double radius = std::sqrt(surface_area / (0.95 * static_cast<double>(limit)));
    for (radius = std::max(radius, 1.001 * farthest / SpacedPoints::kFarthest);; radius *= 1.04) {
        SpacedPoints taken(radius, limit + 1);
        std::vector<Site> result;
        for (const Site& site : sites) {
            if (taken.any_within_radius(site.point.xyz)) continue;
            result.push_back(site);
            if (result.size() > limit) break;
            taken.add(site.point.xyz);
        }
        if (result.size() <= limit) return result;
    }
}

double surface_area(const Mesh& mesh) {
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) area += 0.5 * glm::length(area_vector(mesh, t));
    return area;
}

std::vector<double> vertex_areas(const Mesh& mesh) {
    std::vector<double> areas(mesh.positions.size(), 0.0);
    double all = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const double third = glm::length(area_vector(mesh, t)) / 6.0;
        all += third;
        for (int k = 0; k < 3; ++k) areas[t[k]] += third;
    }
    if (!(all > 0.0)) std::ranges::fill(areas, 1.0);
    return areas;
}

void fit_to_unit_sphere(Mesh& mesh) {
    if (mesh.positions.empty()) return;
    glm::dvec3 low = mesh.positions.front(), high = low;
    for (const glm::dvec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    // Halves first: the sum of two coordinates near the largest double would overflow.
    const glm::dvec3 centre = 0.5 * low + 0.5 * high;
    double farthest = 0.0;
    for (const glm::dvec3& p : mesh.positions) farthest = std::max(farthest, glm::length(p - centre));
    const double scale = farthest > 0.0 ? 1.0 / farthest : 1.0;
    for (glm::dvec3& p : mesh.positions) p = scale * (p - centre);
}

}  // namespace normalscope

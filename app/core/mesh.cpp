#include "core/mesh.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

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

/// A grid of cells one radius wide: whoever is within the radius sits in one of 27 cells.
class SpatialHash {
public:
    SpatialHash(double cell, std::size_t expected) : cell_(cell) { cells_.reserve(expected); }

    bool any_within(const glm::dvec3& p, double radius) const {
        const glm::ivec3 home = cell_of(p);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const auto [first, last] = cells_.equal_range(key(home + glm::ivec3(dx, dy, dz)));
                    for (auto it = first; it != last; ++it)
                        if (glm::dot(it->second - p, it->second - p) < radius * radius) return true;
                }
        return false;
    }
    void add(const glm::dvec3& p) { cells_.emplace(key(cell_of(p)), p); }

private:
    glm::ivec3 cell_of(const glm::dvec3& p) const { return glm::ivec3(glm::floor(p / cell_)); }
    static std::uint64_t key(const glm::ivec3& c) {
        const auto bits = [](int v) { return static_cast<std::uint64_t>(v) & 0x1FFFFFu; };
        return bits(c.x) | bits(c.y) << 21 | bits(c.z) << 42;
    }

    double cell_;
    std::unordered_multimap<std::uint64_t, glm::dvec3> cells_;
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

std::vector<Site> face_sites(const Mesh& mesh) {
    struct Sum {
        glm::dvec3 weighted_centre{0.0}, area_vector{0.0};
        double area = 0.0;
    };
    std::vector<Sum> sums(mesh.face_count());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        Sum& sum = sums[mesh.face_of_triangle.empty() ? i : mesh.face_of_triangle[i]];
        const glm::dvec3 twice_area = area_vector(mesh, t);
        const double area = glm::length(twice_area);
        sum.area += area;
        sum.area_vector += twice_area;
        sum.weighted_centre += area / 3.0 * (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]);
    }
    std::vector<Site> sites;
    sites.reserve(sums.size());
    for (const Sum& sum : sums) {
        const glm::dvec3 normal = unit_or_zero(sum.area_vector);
        if (normal != glm::dvec3(0.0)) sites.push_back({{sum.weighted_centre / sum.area}, {normal}});
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

    // A maximal set of points at least r apart covers each about 0.7 r² of the surface; grow r until it fits.
    for (double radius = std::sqrt(surface_area / (0.95 * static_cast<double>(limit)));; radius *= 1.04) {
        SpatialHash taken(radius, limit);
        std::vector<Site> result;
        for (const Site& site : sites) {
            if (taken.any_within(site.point.xyz, 0.999 * radius)) continue;
            if (result.size() == limit) {
                result.clear();
                break;
            }
            taken.add(site.point.xyz);
            result.push_back(site);
        }
        if (!result.empty()) return result;
    }
}

double surface_area(const Mesh& mesh) {
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) area += 0.5 * glm::length(area_vector(mesh, t));
    return area;
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

#include "core/surface/face_polygon.h"

#include "core/surface/surface_probe.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

namespace normalscope {

namespace {

using Ring = std::vector<glm::dvec3>;

constexpr double kFlat = 1e-5;      // of the object's size from the plane, and as a sine along the rim
constexpr double kAlike = 2e-3;     // sine between two normals: files round them
constexpr double kLeast = 0.12;     // of the object's size: a side of a square as large as the smallest face
constexpr double kPentagon = 0.34;  // of the object's size: the radius of one
constexpr std::size_t kMostCorners = 8;
constexpr std::size_t kMostTriangles = 20'000;  // of one face: this is done every frame

double size_of(const Surface& surface) { return std::max({surface.extent.x, surface.extent.y, surface.extent.z}); }

glm::dvec3 area_vector(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3& a = mesh.positions[t.x];
    return 0.5 * glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
}

// Corners that lie in one place are one, whatever their normals are.
class Corners {
public:
    explicit Corners(const Mesh& mesh) : mesh_(mesh) {}
    std::uint32_t operator()(std::uint32_t vertex) {
        const glm::dvec3& p = mesh_.positions[vertex];
        return seen_.try_emplace({p.x + 0.0, p.y + 0.0, p.z + 0.0}, vertex).first->second;  // + 0: −0 is 0
    }

private:
    const Mesh& mesh_;
    std::map<std::tuple<double, double, double>, std::uint32_t> seen_;
};

// The triangles that lie in the plane of one of them with all three of their normals, and reach it across edges: their rim's
// edges, each from one corner to the next.
using Rim = std::multimap<std::uint32_t, std::uint32_t>;
Rim rim_about(const Mesh& mesh, std::size_t seed, const glm::dvec3& n, double size) {
    const glm::dvec3& in_plane = mesh.positions[mesh.triangles[seed].x];
    const auto lies = [&](std::uint32_t vertex) {
        return std::abs(glm::dot(mesh.positions[vertex] - in_plane, n)) < kFlat * size &&
               glm::length(glm::cross(mesh.normals[vertex], n)) < kAlike;
    };
    Corners corner(mesh);
    std::vector<std::array<std::uint32_t, 3>> flat;
    std::optional<std::size_t> first;  // empty: the seed itself is curved
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        if (!lies(t.x) || !lies(t.y) || !lies(t.z) || !(glm::dot(area_vector(mesh, t), n) > 0.0)) continue;
        if (i == seed) first = flat.size();
        flat.push_back({corner(t.x), corner(t.y), corner(t.z)});
    }
    Rim rim;
    if (!first || flat.size() > kMostTriangles) return rim;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> triangle_of;  // by edge
    for (std::size_t i = 0; i < flat.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) triangle_of[{flat[i][k], flat[i][(k + 1) % 3]}] = i;
    std::vector<bool> reached(flat.size(), false);
    std::vector<std::size_t> left{*first};
    reached[*first] = true;
    while (!left.empty()) {
        const auto here = flat[left.back()];
        left.pop_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = here[k], b = here[(k + 1) % 3];
            const auto beyond = triangle_of.find({b, a});
            if (beyond == triangle_of.end()) {
                rim.emplace(a, b);
            } else if (!reached[beyond->second]) {
                reached[beyond->second] = true;
                left.push_back(beyond->second);
            }
        }
    }
    return rim;
}

// Without corners at which it goes straight on. Empty where there is more than one way around, or it has a hole.
Ring around(const Mesh& mesh, const Rim& rim) {
    Ring all;
    if (rim.empty()) return {};
    std::uint32_t at = rim.begin()->first;
    do {
        if (rim.count(at) != 1 || all.size() > rim.size()) return {};
        all.push_back(mesh.positions[at]);
        at = rim.find(at)->second;
    } while (at != rim.begin()->first);
    if (all.size() != rim.size()) return {};
    Ring ring;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const glm::dvec3 in = all[i] - all[(i + all.size() - 1) % all.size()], out = all[(i + 1) % all.size()] - all[i];
        if (glm::length(glm::cross(in, out)) > kFlat * glm::length(in) * glm::length(out)) ring.push_back(all[i]);
    }
    return ring;
}

bool is_convex(const Ring& ring, const glm::dvec3& n) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec3 &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[(i + 2) % ring.size()];
        if (!(glm::dot(glm::cross(b - a, c - b), n) > 0.0)) return false;
    }
    return true;
}

double area(const Ring& ring, const glm::dvec3& n) {
    double twice = 0.0;
    for (std::size_t i = 2; i < ring.size(); ++i)
        twice += glm::dot(glm::cross(ring[i - 1] - ring[0], ring[i] - ring[0]), n);
    return 0.5 * twice;
}

struct Face {
    Ring ring;
    glm::dvec3 n;
};
std::optional<Face> flat_face(const Surface& surface, Point<Object> p) {
    const Mesh& mesh = surface.mesh;
    const auto seed = nearest_triangle(surface, p);
    if (!seed || surface.implicit) return std::nullopt;
    const glm::dvec3 across = area_vector(mesh, mesh.triangles[*seed]);
    if (!(glm::length(across) > 0.0)) return std::nullopt;
    const glm::dvec3 n = glm::normalize(across);
    const double size = size_of(surface);
    Ring ring = around(mesh, rim_about(mesh, *seed, n, size));
    if (ring.size() < 3 || ring.size() > kMostCorners || !is_convex(ring, n)) return std::nullopt;
    if (std::sqrt(area(ring, n)) < kLeast * size) return std::nullopt;
    return Face{std::move(ring), n};
}

// With its lowest edge along the first tangent, which is level where there is a level one.
Ring pentagon(const Probe& probe, double radius) {
    Ring ring;
    for (int i = 0; i < 5; ++i) {
        const double angle = glm::pi<double>() * (0.4 * i - 0.7);
        ring.push_back(probe.point.xyz + radius * std::cos(angle) * probe.tangents[0].xyz +
                       radius * std::sin(angle) * probe.tangents[1].xyz);
    }
    return ring;
}

}  // namespace

Probe with_polygon(const Probe& probe, const Surface& surface) {
    if (!probe.has_normal()) return probe;
    Probe result = probe;
    Ring ring;
    if (auto face = flat_face(surface, probe.point)) {
        result.normal = {face->n};
        ring = std::move(face->ring);
    } else {
        ring = pentagon(probe, kPentagon * size_of(surface));
    }
    result.polygon.clear();
    for (const glm::dvec3& corner : ring) result.polygon.push_back({corner});
    for (std::size_t k = 0; k < 2; ++k) result.tangents[k] = result.polygon[k + 1] - result.polygon[k];
    return result;
}

}  // namespace normalscope

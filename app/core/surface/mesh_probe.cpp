#include "core/surface/mesh_probe.h"

#include "core/base/beside.h"
#include "core/surface/box_image.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <compare>
#include <limits>
#include <tuple>
#include <vector>

namespace normalscope {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A probe at barycentric coordinates of a triangle.
Probe probe_at(const Mesh& mesh, const glm::uvec3& t, const glm::dvec3& b) {
    const auto mix = [&](const std::vector<glm::dvec3>& of) { return b.x * of[t.x] + b.y * of[t.y] + b.z * of[t.z]; };
    glm::dvec3 n = mix(mesh.normals);
    // Opposite vertex normals can cancel, and a vertex may have none: the triangle's own normal always serves.
    if (glm::length(n) < 1e-9)
        n = glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
    return probe_with({mix(mesh.positions)}, {glm::length(n) > 0.0 ? n : glm::dvec3(0.0, 0.0, 1.0)});
}

// Barycentric coordinates of the point of a triangle nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
glm::dvec3 nearest_barycentric(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& p) {
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const double v = d1 / (d1 - d3);
        return {1.0 - v, v, 0.0};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const double w = d2 / (d2 - d6);
        return {1.0 - w, 0.0, w};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0.0, 1.0 - w, w};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

// From the image of a triangle back to it: each corner counts by what its image was divided by.
glm::dvec3 before(const Transform<World, Object>& m, const Mesh& mesh, const glm::uvec3& t, glm::dvec3 barycentric) {
    if (m.affine()) return barycentric;
    for (int k = 0; k < 3; ++k) barycentric[k] /= m.w({mesh.positions[t[k]]});
    return barycentric / (barycentric.x + barycentric.y + barycentric.z);
}

// Where a mesh's vertices are sent: all of them at once where every triangle is to be looked at, else those asked for.
template <class Send>
class Sent {
public:
    Sent(const Mesh& mesh, const TriangleTree* tree, Send send) : mesh_(mesh), send_(std::move(send)) {
        if (tree) return;
        all_.reserve(mesh.positions.size());
        for (const glm::dvec3& p : mesh.positions) all_.push_back(send_(Point<Object>{p}));
    }
    glm::dvec3 operator[](std::uint32_t vertex) const {
        return all_.empty() ? send_(Point<Object>{mesh_.positions[vertex]}) : all_[vertex];
    }

private:
    const Mesh& mesh_;
    Send send_;
    std::vector<glm::dvec3> all_;
};

// NaN for what has no image, or so far away a one that no ray could be told to meet it.
glm::dvec3 image(const Transform<World, Object>& m, Point<Object> p) {
    return m.w(p) > kNearInfinity ? m(p).xyz : glm::dvec3(std::numeric_limits<double>::quiet_NaN());
}

template <class Bound, class Look>
void search(const Mesh& mesh, const TriangleTree* tree, const Bound& bound, const Look& look) {
    if (tree)
        tree->search(bound, look);
    else
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) look(i);
}

struct Met {
    double distance = kInfinity;
    glm::dvec3 barycentric{0.0};
};

// In world space, since M may have no inverse. Möller & Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
std::optional<Met> meets(const Ray<World>& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    // The middle of the picture often looks at an edge or a corner; rounding must not let the ray slip between the
    // triangles there and find the object's far side.
    constexpr double kSlack = 1e-9;
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 p = glm::cross(ray.direction.xyz, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return std::nullopt;
    const glm::dvec3 s = ray.origin.xyz - a;
    const double u = glm::dot(s, p) / determinant;
    if (!(u >= -kSlack && u <= 1.0 + kSlack)) return std::nullopt;
    const glm::dvec3 q = glm::cross(s, ab);
    const double v = glm::dot(ray.direction.xyz, q) / determinant;
    if (!(v >= -kSlack && u + v <= 1.0 + kSlack)) return std::nullopt;
    const double distance = glm::dot(ac, q) / determinant;
    if (!(distance > 0.0)) return std::nullopt;
    // One that lies in the triangle's plane would, by rounding, meet it anywhere.
    const formulas::Box box{glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
    if (!holds(box, ray, distance)) return std::nullopt;
    return Met{distance, glm::max(glm::dvec3(1.0 - u - v, u, v), 0.0)};
}

// An edge of a triangle, as near to a pixel as it comes.
struct NearEdge {
    std::size_t triangle = 0;
    int edge = 0;  // from this corner to the next
    double distance = 0.0, depth = 0.0;
    glm::dvec3 barycentric{0.0};
};

// What the camera sees of several edges: of those that come equally near, the one before the others.
const NearEdge* seen_first(std::vector<NearEdge>& edges) {
    std::ranges::sort(edges, {}, [](const NearEdge& e) { return std::pair(e.triangle, e.edge); });
    const NearEdge* best = nullptr;
    for (const NearEdge& e : edges) {
        if (best &&
            (e.distance > best->distance + 1e-9 || (e.distance > best->distance - 1e-9 && e.depth >= best->depth)))
            continue;
        best = &e;
    }
    return best;
}

std::optional<NearEdge> edge_near(glm::dvec2 pixel, const glm::dvec3& a, const glm::dvec3& b, int k) {
    if (!(a.z > 0.0 && b.z > 0.0)) return std::nullopt;
    const glm::dvec2 ab = glm::dvec2(b) - glm::dvec2(a), ap = pixel - glm::dvec2(a);
    const double length2 = glm::dot(ab, ab);
    const double s = length2 > 0.0 ? glm::clamp(glm::dot(ap, ab) / length2, 0.0, 1.0) : 0.0;
    NearEdge edge{.edge = k, .distance = glm::length(ap - s * ab)};
    // Back from the picture to the edge: depth, not the parameter, is linear in 1/z.
    edge.depth = 1.0 / ((1.0 - s) / a.z + s / b.z);
    const int l = (k + 1) % 3;
    edge.barycentric[l] = s * edge.depth / b.z;
    edge.barycentric[k] = 1.0 - edge.barycentric[l];
    return edge;
}

std::optional<NearEdge> silhouette_near(const Mesh& mesh, const Transform<World, Object>& m, const CameraView& view,
                                        glm::dvec2 pixel, const TriangleTree* tree) {
    constexpr double kAlike = 1e-6;  // pixels: any that could be taken in place of the nearest
    const Sent pixels(mesh, tree, [&](Point<Object> p) { return view.pixel({image(m, p)}); });
    std::vector<NearEdge> nearest;
    double least = kInfinity;
    search(
        mesh, tree, [&](const formulas::Box& box) { return pixels_between(pixel, box, m, view) - kAlike; },
        [&](std::size_t i) {
            const glm::uvec3& t = mesh.triangles[i];
            const std::array corners{pixels[t.x], pixels[t.y], pixels[t.z]};
            for (std::size_t k = 0; k < 3; ++k) {
                auto edge = edge_near(pixel, corners[k], corners[(k + 1) % 3], static_cast<int>(k));
                if (!edge || !(edge->distance <= least + kAlike)) continue;
                edge->triangle = i;
                if (edge->distance < least) {
                    least = edge->distance;
                    std::erase_if(nearest, [&](const NearEdge& e) { return e.distance > least + kAlike; });
                }
                nearest.push_back(*edge);
            }
            return least;
        });
    const NearEdge* first = seen_first(nearest);
    return first ? std::optional(*first) : std::nullopt;
}

}  // namespace

std::optional<SurfaceHit> first_hit(const Mesh& mesh, const Transform<World, Object>& world_from_object,
                                    const Ray<World>& ray, const TriangleTree* tree) {
    const Sent world(mesh, tree, [&](Point<Object> p) { return image(world_from_object, p); });
    const BoxImage box_image(world_from_object);
    Met nearest;
    std::size_t triangle = 0;
    search(
        mesh, tree, [&](const formulas::Box& box) { return box_image.entry(box, ray); },
        [&](std::size_t i) {
            const glm::uvec3& t = mesh.triangles[i];
            const auto met = meets(ray, world[t.x], world[t.y], world[t.z]);
            if (met && std::tie(met->distance, i) < std::tie(nearest.distance, triangle)) {
                nearest = *met;
                triangle = i;
            }
            return nearest.distance;
        });
    if (nearest.distance == kInfinity) return std::nullopt;
    glm::dvec3& b = nearest.barycentric;
    b /= b.x + b.y + b.z;
    const glm::uvec3& t = mesh.triangles[triangle];
    return SurfaceHit{probe_at(mesh, t, before(world_from_object, mesh, t, b)), nearest.distance};
}

std::optional<std::size_t> nearest_triangle(const Mesh& mesh, Point<Object> p, const TriangleTree* tree) {
    constexpr std::size_t kWorthAThread = 100'000;
    struct Nearest {
        double squared = kInfinity;
        std::size_t triangle = 0;
        auto operator<=>(const Nearest&) const = default;
        void look_at(const Mesh& mesh, std::size_t i, const glm::dvec3& p) {
            const glm::uvec3& t = mesh.triangles[i];
            const glm::dvec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
            const glm::dvec3 at = nearest_barycentric(a, b, c, p);
            const glm::dvec3 gap = at.x * a + at.y * b + at.z * c - p;
            const Nearest other{glm::dot(gap, gap), i};
            if (other < *this) *this = other;
        }
    };
    const std::size_t count = mesh.triangles.size();
    std::vector<Nearest> nearest(tree ? 1 : threads_for(count, kWorthAThread));
    if (tree)
        tree->search([&](const formulas::Box& box) { return squared_gap(box, p.xyz); },
                     [&](std::size_t i) {
                         nearest[0].look_at(mesh, i, p.xyz);
                         return nearest[0].squared;
                     });
    else
        in_parts(nearest.size(), count, [&](std::size_t part, std::size_t begin, std::size_t end) {
            Nearest own;
            for (std::size_t i = begin; i < end; ++i) own.look_at(mesh, i, p.xyz);
            nearest[part] = own;
        });
    const Nearest first = *std::ranges::min_element(nearest);
    return first.squared < kInfinity ? std::optional(first.triangle) : std::nullopt;
}

std::optional<Probe> nearest_probe(const Mesh& mesh, Point<Object> p, const TriangleTree* tree) {
    const auto triangle = nearest_triangle(mesh, p, tree);
    if (!triangle) return std::nullopt;
    const glm::uvec3& t = mesh.triangles[*triangle];
    return probe_at(mesh, t, nearest_barycentric(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], p.xyz));
}

std::optional<Probe> probe_in_view(const Mesh& mesh, const Transform<World, Object>& world_from_object,
                                   const CameraView& view, glm::dvec2 pixel, const TriangleTree* tree) {
    if (const auto hit = first_hit(mesh, world_from_object, view.ray(pixel), tree)) return hit->probe;
    // The ray misses: nothing covers the pixel, so the nearest edge in the picture is one that the camera sees.
    const auto edge = silhouette_near(mesh, world_from_object, view, pixel, tree);
    if (!edge) return std::nullopt;
    const glm::uvec3& t = mesh.triangles[edge->triangle];
    return probe_at(mesh, t, before(world_from_object, mesh, t, edge->barycentric));
}

}  // namespace normalscope

#include "core/surface/probe.h"

#include "core/scene/mistakes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

namespace {

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

// NaN for what has no image, or so far away a one that no ray could be told to meet it.
std::vector<glm::dvec3> images(const Mesh& mesh, const Transform<World, Object>& world_from_object) {
    constexpr double kNearInfinity = 1e-6;  // of w, which is 1 where M is affine
    std::vector<glm::dvec3> world(mesh.positions.size(), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    for (std::size_t i = 0; i < world.size(); ++i)
        if (const Point<Object> p{mesh.positions[i]}; world_from_object.w(p) > kNearInfinity)
            world[i] = world_from_object(p).xyz;
    return world;
}

}  // namespace

Probe probe_with(Point<Object> point, Normal<Object> normal) {
    const glm::dvec3 n = glm::normalize(normal.xyz);
    // The tangent that is level where there is one: it is easier to read than an arbitrary one.
    const glm::dvec3 level = glm::cross(glm::dvec3(0.0, 1.0, 0.0), n);
    const glm::dvec3 t0 =
        glm::length(level) > 1e-6 ? glm::normalize(level) : glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), n));
    return {point, {n}, {Vector<Object>{t0}, Vector<Object>{glm::cross(n, t0)}}};
}

ProbeInWorld in_world(const Probe& probe, const Transform<World, Object>& world_from_object) {
    return in_world(probe, world_from_object, Scene{});
}

ProbeInWorld in_world(const Probe& probe, const Transform<World, Object>& world_from_object, const Scene& scene,
                      double right_power) {
    ProbeInWorld result;
    result.object = probe;
    result.point = world_from_object(probe.point);
    result.affine = world_from_object.affine();
    const std::optional<glm::dmat3> mistaken = mistaken_tangents(scene, world_from_object);
    for (std::size_t k = 0; k < 2; ++k) {
        const Vector<Object> t = probe.tangents[k];
        result.tangents[k] = mistaken ? Vector<World>{*mistaken * t.xyz} : world_from_object(probe.point, t);
    }
    for (std::size_t r = 0; r < kRules.size() && probe.has_normal(); ++r) {
        std::optional<Normal<World>> n = transform_normal(world_from_object, probe.normal, kRules[r]);
        const bool bent = kRules[r] == Rule::InverseTranspose && right_power != -1.0;
        if (bent || (kRules[r] == Rule::Naive && !plainly_naive(scene))) {
            const std::optional<NormalMap> map = normal_map(scene, world_from_object, kRules[r], right_power);
            n = map ? std::optional((*map)(probe.normal)) : std::nullopt;
        }
        result.normals[r] = n;
        if (n) result.dots[r] = std::array{dot(*n, result.tangents[0]), dot(*n, result.tangents[1])};
    }
    for (const Point<Object>& corner : probe.polygon)
        if (world_from_object.reaches(corner)) result.polygon.push_back(world_from_object(corner));
    if (result.polygon.size() < probe.polygon.size()) result.polygon.clear();
    if (!probe.has_normal()) return result;
    const auto by_inverse = world_from_object(probe.point, probe.normal);
    const Normal<World> by_cofactor = transform_normal_by_cofactor(world_from_object.at(probe.point), probe.normal);
    if (by_inverse || glm::length(by_cofactor.xyz) > 0.0) result.truth = by_inverse.value_or(by_cofactor);
    if (by_inverse && result.normals[0]) result.error_degrees = angle_degrees(result.normals[0]->xyz, by_inverse->xyz);
    return result;
}

std::optional<SurfaceHit> first_hit(const Mesh& mesh, const Transform<World, Object>& world_from_object,
                                    const Ray<World>& ray) {
    // In world space, since M may have no inverse. Möller & Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
    const std::vector<glm::dvec3> world = images(mesh, world_from_object);

    // The middle of the picture often looks at an edge or a corner; rounding must not let the ray slip between the
    // triangles there and find the object's far side.
    constexpr double kSlack = 1e-9;
    double nearest = std::numeric_limits<double>::infinity();
    const glm::uvec3* triangle = nullptr;
    glm::dvec3 barycentric(0.0);
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 ab = world[t.y] - world[t.x], ac = world[t.z] - world[t.x];
        const glm::dvec3 p = glm::cross(ray.direction.xyz, ac);
        const double determinant = glm::dot(ab, p);
        if (determinant == 0.0) continue;
        const glm::dvec3 s = ray.origin.xyz - world[t.x];
        const double u = glm::dot(s, p) / determinant;
        if (!(u >= -kSlack && u <= 1.0 + kSlack)) continue;
        const glm::dvec3 q = glm::cross(s, ab);
        const double v = glm::dot(ray.direction.xyz, q) / determinant;
        if (!(v >= -kSlack && u + v <= 1.0 + kSlack)) continue;
        const double distance = glm::dot(ac, q) / determinant;
        if (distance > 0.0 && distance < nearest) {
            nearest = distance;
            triangle = &t;
            barycentric = glm::max(glm::dvec3(1.0 - u - v, u, v), 0.0);
        }
    }
    if (!triangle) return std::nullopt;
    barycentric /= barycentric.x + barycentric.y + barycentric.z;
    return SurfaceHit{probe_at(mesh, *triangle, before(world_from_object, mesh, *triangle, barycentric)), nearest};
}

std::optional<std::size_t> nearest_triangle(const Mesh& mesh, Point<Object> p) {
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> triangle;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const glm::dvec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
        const glm::dvec3 at = nearest_barycentric(a, b, c, p.xyz);
        const glm::dvec3 gap = at.x * a + at.y * b + at.z * c - p.xyz;
        if (glm::dot(gap, gap) < nearest) {
            nearest = glm::dot(gap, gap);
            triangle = i;
        }
    }
    return triangle;
}

std::optional<Probe> nearest_probe(const Mesh& mesh, Point<Object> p) {
    const auto triangle = nearest_triangle(mesh, p);
    if (!triangle) return std::nullopt;
    const glm::uvec3& t = mesh.triangles[*triangle];
    return probe_at(mesh, t, nearest_barycentric(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], p.xyz));
}

std::optional<Probe> probe_in_view(const Mesh& mesh, const Transform<World, Object>& world_from_object,
                                   const CameraView& view, glm::dvec2 pixel) {
    if (const auto hit = first_hit(mesh, world_from_object, view.ray(pixel))) return hit->probe;

    // The ray misses: nothing covers the pixel, so the nearest edge in the picture is one that the camera sees.
    std::vector<glm::dvec3> pixels = images(mesh, world_from_object);
    for (glm::dvec3& p : pixels) p = view.pixel({p});
    double nearest = std::numeric_limits<double>::infinity(), nearest_depth = 0.0;
    const glm::uvec3* triangle = nullptr;
    glm::dvec3 barycentric(0.0);
    for (const glm::uvec3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3;
            const glm::dvec3 &a = pixels[t[k]], &b = pixels[t[l]];
            if (!(a.z > 0.0 && b.z > 0.0)) continue;
            const glm::dvec2 ab = glm::dvec2(b) - glm::dvec2(a), ap = pixel - glm::dvec2(a);
            const double length2 = glm::dot(ab, ab);
            const double s = length2 > 0.0 ? glm::clamp(glm::dot(ap, ab) / length2, 0.0, 1.0) : 0.0;
            const double distance = glm::length(ap - s * ab);
            // Back from the picture to the edge: depth, not the parameter, is linear in 1/z.
            const double depth = 1.0 / ((1.0 - s) / a.z + s / b.z);
            if (distance > nearest + 1e-9 || (distance > nearest - 1e-9 && depth >= nearest_depth && triangle))
                continue;
            nearest = distance;
            nearest_depth = depth;
            triangle = &t;
            barycentric = glm::dvec3(0.0);
            barycentric[l] = s * depth / b.z;
            barycentric[k] = 1.0 - barycentric[l];
        }
    if (!triangle) return std::nullopt;
    return probe_at(mesh, *triangle, before(world_from_object, mesh, *triangle, barycentric));
}

}  // namespace normalscope

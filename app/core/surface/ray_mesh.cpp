#include "core/surface/ray_mesh.h"

#include "core/mesh/closed_mesh.h"
#include "core/surface/stopped.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr int kTrialRays = 8;                     // a side
constexpr std::int64_t kTrialEffort = 1'000'000;  // for one axis
constexpr std::int64_t kMostEffort = 4'000'000;   // a tenth of a second, or two

struct RayGrid {
    glm::length_t axis = 0;
    std::vector<glm::dvec3> points;
    std::array<std::vector<std::uint32_t>, 2> sheets;  // the index of each ray's first and last point
};

// Where a ray goes through the surface: the first and the last place, if between them or beside them f changes its sign. A
// root that only touches may come as two, by rounding.
std::vector<glm::dvec3> ends(const ImplicitSurface& surface, const Ray<Object>& ray, formulas::Effort& effort) {
    const std::vector<formulas::Root> roots = surface.hits(ray, formulas::Wanted::All, &effort);
    if (roots.empty()) return {};
    const double first = roots.front().t, last = roots.back().t, beside = 1e-6 * surface.source().bound;
    const auto negative = [&](double t) { return surface.at(ray.origin + t * ray.direction).value < 0.0; };
    const bool before = negative(first - beside), between = negative(0.5 * (first + last)),
               after = negative(last + beside);
    if (before == after && (before == between || first == last)) return {};
    std::vector<glm::dvec3> points{(ray.origin + first * ray.direction).xyz};
    if (last > first) points.push_back((ray.origin + last * ray.direction).xyz);
    return points;
}

RayGrid cast(const ImplicitSurface& surface, const formulas::Box& box, int cells, glm::length_t axis,
             std::int64_t most_effort, const Stop& stop) {
    RayGrid grid{.axis = axis};
    const glm::dvec3 size = box.high - box.low;
    formulas::Effort effort{most_effort};
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            go_on_unless(stop);
            Ray<Object> ray{{box.low}, {glm::dvec3(0.0)}};
            ray.origin.xyz[axis] -= 0.01 * size[axis];
            ray.origin.xyz[(axis + 1) % 3] += size[(axis + 1) % 3] * (i + 0.5) / cells;
            ray.origin.xyz[(axis + 2) % 3] += size[(axis + 2) % 3] * (j + 0.5) / cells;
            ray.direction.xyz[axis] = 1.0;
            const std::vector<glm::dvec3> points = ends(surface, ray, effort);
            for (std::size_t k = 0; k < 2; ++k) {
                const bool there = points.size() > k;
                grid.sheets[k].push_back(there ? static_cast<std::uint32_t>(grid.points.size()) : kNone);
                if (there) grid.points.push_back(points[k]);
            }
        }
    return grid;
}

}  // namespace

Mesh ray_mesh(const ImplicitSurface& surface, const formulas::Box& box, int cells, const Stop& stop) {
    RayGrid best;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        RayGrid grid = cast(surface, box, kTrialRays, axis, kTrialEffort, stop);
        if (grid.points.size() > best.points.size()) best = std::move(grid);
    }
    if (best.points.empty()) return {};
    best = cast(surface, box, cells, best.axis, kMostEffort, stop);
    Mesh mesh;
    mesh.positions = best.points;
    for (const glm::dvec3& p : mesh.positions) {
        const glm::dvec3 g = surface.at({p}).gradient;
        const double length = glm::length(g);
        mesh.normals.push_back(length > 0.0 && std::isfinite(length) ? g / length : glm::dvec3(0.0));
    }
    const glm::dvec3 size = box.high - box.low;
    const double near = 4.0 * glm::length(size) / cells;
    const auto add = [&](glm::uvec3 t) {
        const glm::dvec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
        if (glm::distance(a, b) > near || glm::distance(b, c) > near || glm::distance(c, a) > near) return;
        if (glm::dot(glm::cross(b - a, c - a), mesh.normals[t.x]) < 0.0) std::swap(t.y, t.z);
        mesh.triangles.push_back(t);
    };
    const auto side = static_cast<std::size_t>(cells);
    for (const auto& sheet : best.sheets)
        for (std::size_t k = 0; k + side < sheet.size(); ++k) {
            if (k % side + 1 == side) continue;
            const std::uint32_t a = sheet[k], b = sheet[k + 1], c = sheet[k + side + 1], d = sheet[k + side];
            if (a != kNone && b != kNone && c != kNone) add({a, b, c});
            if (a != kNone && c != kNone && d != kNone) add({a, c, d});
        }
    if (mesh.triangles.empty()) return {};
    mesh.closed = edges_cancel(mesh.triangles);
    return mesh;
}

}  // namespace normalscope

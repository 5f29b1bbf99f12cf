#include "core/surface/gradient_report.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr double kStep = 1e-3;   // of the bound; as one would choose it who knows nothing of f
constexpr double kBeside = 0.1;  // of the bound: a triangle further away tells nothing of the point

std::optional<GradientReport::Other> of_polygon(const Surface& surface, Point<Object> p) {
    const auto index = nearest_triangle(surface, p);
    if (!index) return std::nullopt;
    const glm::uvec3& t = surface.mesh.triangles[*index];
    const glm::dvec3 &a = surface.mesh.positions[t.x], &b = surface.mesh.positions[t.y],
                     &c = surface.mesh.positions[t.z];
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    if (glm::distance((a + b + c) / 3.0, p.xyz) > kBeside * surface.implicit->source().bound) return std::nullopt;
    if (!(glm::length(cross) > 0.0)) return std::nullopt;
    return GradientReport::Other{glm::normalize(cross), std::nullopt};
}

}  // namespace

glm::dvec3 GradientReport::Other::direction() const {
    const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    return vector == glm::dvec3(0.0) ? vector : glm::normalize(vector / largest);
}

std::optional<GradientReport> gradient_report(const Surface& surface, const Probe& probe) {
    if (!surface.implicit) return std::nullopt;
    const ImplicitSurface& implicit = *surface.implicit;
    GradientReport report;
    const formulas::Sample exact = implicit.written_at(probe.point);
    report.f = exact.value;
    if (const glm::dvec3& g = exact.gradient; std::isfinite(g.x + g.y + g.z)) {
        report.gradient = g;
        report.length = std::hypot(g.x, g.y, g.z);
    }
    if (!probe.borrowed_from && glm::length(probe.normal.xyz) > 0.0) report.normal = probe.normal;

    report.step = kStep * implicit.source().bound;
    for (glm::length_t i = 0; i < 3; ++i) {
        glm::dvec3 before = probe.point.xyz, after = before;
        before[i] -= report.step;
        after[i] += report.step;
        report.differences.vector[i] =
            (formulas::value(implicit.written_program(), after) - formulas::value(implicit.written_program(), before)) /
            (after[i] - before[i]);
    }
    report.polygon = of_polygon(surface, probe.point);
    if (!report.normal) return report;
    if (std::isfinite(glm::length(report.differences.vector)))
        report.differences.degrees_off = angle_degrees(report.differences.vector, report.normal->xyz);
    if (report.polygon) report.polygon->degrees_off = angle_degrees(report.polygon->vector, report.normal->xyz);
    return report;
}

}  // namespace normalscope

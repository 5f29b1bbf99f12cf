#include "core/surface/box_cut.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace normalscope {

namespace {

constexpr int kNewtonSteps = 8;

// Down to f = 0 within the face that the point lies on, and not far.
glm::dvec3 onto_face(const ImplicitSurface& surface, glm::dvec3 p, glm::length_t face, double reach) {
    const double bound = surface.source().bound;
    const glm::dvec3 start = p;
    for (int i = 0; i < kNewtonSteps; ++i) {
        const formulas::Sample s = surface.at({p});
        glm::dvec3 slope = s.gradient;
        slope[face] = 0.0;
        const glm::dvec3 next = p - s.value / glm::dot(slope, slope) * slope;
        if (!(glm::distance(next, start) <= reach)) break;
        p = next;
    }
    return glm::clamp(p, glm::dvec3(-bound), glm::dvec3(bound));
}

// Where the edge from a, within the cube, to b, beyond it, leaves it.
glm::dvec3 leaving(const ImplicitSurface& surface, const glm::dvec3& a, const glm::dvec3& b) {
    const double bound = surface.source().bound;
    double part = 1.0;
    glm::length_t face = 0;
    for (glm::length_t i = 0; i < 3; ++i) {
        if (std::abs(b[i]) <= bound) continue;
        const double at = (std::copysign(bound, b[i]) - a[i]) / (b[i] - a[i]);
        if (at < part) part = at, face = i;
    }
    glm::dvec3 p = glm::mix(a, b, part);
    p[face] = std::copysign(bound, b[face]);
    return onto_face(surface, p, face, glm::distance(a, b));
}

}  // namespace

void cut_to_box(const ImplicitSurface& surface, std::vector<glm::dvec3>& positions,
                std::vector<glm::uvec3>& triangles) {
    std::vector<bool> inside;
    for (const glm::dvec3& p : positions) inside.push_back(surface.inside_clip(p));
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cuts;
    const auto cut = [&](std::uint32_t in, std::uint32_t out) {
        const auto [known, is_new] = cuts.try_emplace({in, out}, static_cast<std::uint32_t>(positions.size()));
        if (is_new) positions.push_back(leaving(surface, positions[in], positions[out]));
        return known->second;
    };
    std::vector<glm::uvec3> kept;
    for (glm::uvec3 t : triangles) {
        const int count = (inside[t.x] ? 1 : 0) + (inside[t.y] ? 1 : 0) + (inside[t.z] ? 1 : 0);
        if (count == 0) continue;
        if (count == 3) {
            kept.push_back(t);
            continue;
        }
        // The corner that is alone on its side comes first.
        while (inside[t.x] != (count == 1)) t = {t.y, t.z, t.x};
        if (count == 1) {
            kept.push_back({t.x, cut(t.x, t.y), cut(t.x, t.z)});
        } else {
            const std::uint32_t first = cut(t.y, t.x), last = cut(t.z, t.x);
            kept.push_back({first, t.y, t.z});
            kept.push_back({first, t.z, last});
        }
    }
    triangles = std::move(kept);
}

}  // namespace normalscope

#include "core/surface/newton_steps.h"

#include <glm/geometric.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

namespace normalscope {

namespace {

// A step of a few roundings leads nowhere.
bool rests(const glm::dvec3& here, const glm::dvec3& next) {
    constexpr double kRoundings = 16.0 * std::numeric_limits<double>::epsilon();
    return glm::length(next - here) <= kRoundings * glm::length(here);
}

}  // namespace

// Most points come to rest within a few steps, or go to and fro between two places, as rounding makes them do: those are done.
std::vector<formulas::Sample> newton_steps(const formulas::Program& program, std::vector<glm::dvec3>& points, int most,
                                           double reach) {
    const std::vector<glm::dvec3> start = points;
    std::vector<formulas::Sample> samples(points.size()), there;  // there: at the moving ones
    std::vector<std::uint32_t> moving(points.size());
    std::iota(moving.begin(), moving.end(), 0u);
    std::vector<glm::dvec3> at = points, before = points;
    for (int left = most; left >= 0 && !moving.empty(); --left) {
        there.resize(moving.size());
        formulas::samples(program, at, there);
        std::size_t still_moving = 0;
        for (std::size_t k = 0; k < moving.size(); ++k) {
            const std::uint32_t p = moving[k];
            const glm::dvec3 here = at[k], last = before[k], &g = there[k].gradient;
            const glm::dvec3 next = here - there[k].value / glm::dot(g, g) * g;
            const bool to_and_fro = left < most && next == last;
            if (to_and_fro && left % 2 == 1) {
                points[p] = last;  // where it would end; f is known there
                continue;
            }
            points[p] = here;
            samples[p] = there[k];
            if (left == 0 || to_and_fro || rests(here, next) || !(glm::length(next - start[p]) <= reach)) continue;
            moving[still_moving] = p;
            before[still_moving] = here;
            at[still_moving++] = next;
        }
        moving.resize(still_moving);
        at.resize(still_moving);
    }
    return samples;
}

glm::dvec3 onto_ball(const formulas::Program& program, double radius, glm::dvec3 p, int most, double reach) {
    for (int i = 0; i < most; ++i) {
        const formulas::Sample s = formulas::sample(program, p);
        const double f = s.value, g = 0.5 * (glm::dot(p, p) - radius * radius);
        const glm::dvec3 &a = s.gradient, &b = p;
        const double aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b);
        const double determinant = aa * bb - ab * ab;
        if (!(determinant > 1e-12 * aa * bb)) break;
        const glm::dvec3 next = p - (bb * f - ab * g) / determinant * a - (aa * g - ab * f) / determinant * b;
        if (!(glm::length(next - p) < reach)) break;
        p = next;
    }
    return p;
}

}  // namespace normalscope

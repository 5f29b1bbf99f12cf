#include "core/surface/formula_note.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace normalscope {

namespace {

constexpr int kTrialRays = 16;    // along each axis, a side
constexpr int kRayStride = 99;    // odd, so that all are visited
constexpr int kTrialPoints = 7;   // a side
constexpr double kBeside = 2e-3;  // of the bound: how far from a zero a ray passes that tells a sheet from a thread
constexpr double kSamePoint = 1e-4;
constexpr std::int64_t kMostEffort = 8'000'000;  // some tenths of a second

// Whether any of a grid of rays meets it: a formula such as (x − 1)² touches zero without crossing it.
bool rays_meet(const ImplicitSurface& surface) {
    const double bound = surface.source().bound;
    formulas::Effort effort{kMostEffort};
    constexpr int kRays = kTrialRays * kTrialRays;
    // In steps through the grid, along all axes in turn: where the effort does not suffice for all they are spread.
    for (int k = 0, i = 0; k < kRays; ++k, i = (i + kRayStride) % kRays)
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            glm::dvec3 from(0.0), along(0.0);
            from[axis] = -2.0 * bound;
            along[axis] = 1.0;
            from[(axis + 1) % 3] = bound * (2.0 * (i % kTrialRays + 0.5) / kTrialRays - 1.0);
            from[(axis + 2) % 3] = bound * (2.0 * (i / kTrialRays + 0.5) / kTrialRays - 1.0);
            if (surface.first_hit({{from}, {along}}, &effort)) return true;
        }
    return false;
}

/// Zeros that no ray of the grid has met, found by going down |f| from all over the ball or cube.
struct Zeros {
    std::vector<glm::dvec3> places;
    bool below = false, above = false;  ///< whether f < 0, or f > 0, was seen anywhere
};

Zeros zeros_of(const ImplicitSurface& surface) {
    const double bound = surface.source().bound;
    Zeros zeros;
    for (const glm::dvec3& start : surface.points_throughout(kTrialPoints)) {
        const double f = surface.at({start}).value;
        zeros.below = zeros.below || f < 0.0;
        zeros.above = zeros.above || f > 0.0;
        if (const auto zero = surface.onto_surface({start}, 2.0 * bound); zero && surface.inside_clip(zero->xyz))
            zeros.places.push_back(zero->xyz);
    }
    return zeros;
}

// A ray that passes a sheet's point at some distance meets the sheet; one that passes a thread's misses it.
bool is_sheet(const ImplicitSurface& surface, const glm::dvec3& zero, formulas::Effort& effort) {
    const double bound = surface.source().bound;
    int met = 0;
    constexpr std::array kDirections{glm::dvec3(0.8, 0.36, 0.48), glm::dvec3(-0.48, 0.8, 0.36),
                                     glm::dvec3(0.36, -0.48, 0.8)};
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 d = kDirections[k],
                         aside = kBeside * bound * glm::normalize(glm::cross(d, kDirections[(k + 1) % 3]));
        const double near = 20.0 * kBeside * bound;
        const Ray<Object> ray{{zero + aside - 3.0 * bound * d}, {d}};
        for (const formulas::Root& root : surface.hits(ray, formulas::Wanted::All, &effort))
            if (std::abs(root.t - 3.0 * bound) < near) {
                ++met;
                break;
            }
    }
    return met >= 2;
}

std::string point_text(const glm::dvec3& p, double bound) {
    std::string text = "(";
    for (glm::length_t i = 0; i < 3; ++i) {
        char number[32];
        std::snprintf(number, sizeof number, "%.3g", std::abs(p[i]) < 1e-6 * bound ? 0.0 : p[i]);
        text += (i > 0 ? ", " : "") + (number[0] == '-' ? "\u2212" + std::string(number + 1) : std::string(number));
    }
    return text + ")";
}

// f may be negative within a ball far smaller than the grid's cells.
void look_around(const ImplicitSurface& surface, Zeros& zeros) {
    const double bound = surface.source().bound;
    for (const glm::dvec3& p : zeros.places)
        for (const double away : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
            for (int k = 0; k < 8; ++k) {
                const glm::dvec3 side(k & 1 ? 1.0 : -0.9, k & 2 ? 0.8 : -1.0, k & 4 ? 0.9 : -0.8);
                const double f = surface.at({p + away * bound * side}).value;
                zeros.below = zeros.below || f < 0.0;
                zeros.above = zeros.above || f > 0.0;
            }
}

std::string thin(const Zeros& zeros, double bound) {
    bool one_point = true;
    for (const glm::dvec3& p : zeros.places)
        one_point = one_point && glm::distance(p, zeros.places.front()) < kSamePoint * bound;
    const bool up = zeros.below;
    return std::string("f comes ") + (up ? "up" : "down") + " to 0 " + (one_point ? "at " : "as at ") +
           point_text(zeros.places.front(), bound) + " but is never " + (up ? "positive" : "negative") +
           (one_point ? ": a point" : ": a line or some points") + ", too thin for a surface. Nothing is drawn.";
}

}  // namespace

std::string note_on(const ImplicitSurface& surface, const Mesh& mesh) {
    if (surface.zero_everywhere()) return "f is 0 everywhere: all of space, and no surface. Nothing is drawn.";
    if (!mesh.triangles.empty()) return {};
    const std::string within = surface.source().clip == Clip::Ball ? "the ball" : "the cube";
    const std::string touches =
        "f touches 0 within " + within +
        " without changing its sign. Only rays find such a surface: it has no triangles, and no arrows.";
    const std::string none = "No zero of f was found within " + within + ", so nothing is drawn. Try a larger bound.";
    if (const auto& p = surface.zero_throughout())
        return "f is 0 throughout a part of " + within + ", as around " + point_text(*p, surface.source().bound) +
               ", and changes its sign nowhere: a solid, and no surface. Nothing is drawn.";
    if (!surface.region()) return none;
    if (rays_meet(surface)) return touches;
    Zeros zeros = zeros_of(surface);
    if (zeros.places.empty()) return none;
    formulas::Effort effort{kMostEffort};
    for (const glm::dvec3& zero : zeros.places)
        if (is_sheet(surface, zero, effort)) return touches;
    look_around(surface, zeros);
    if (zeros.below == zeros.above)
        return "What f has of zeros, as at " + point_text(zeros.places.front(), surface.source().bound) +
               ", is too small to be drawn. Try a smaller bound.";
    return thin(zeros, surface.source().bound);
}

}  // namespace normalscope

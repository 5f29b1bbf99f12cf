#include "core/surface/formula_note.h"

#include "core/base/decimal.h"
#include "core/program/zero_crossing.h"
#include "core/surface/stopped.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

constexpr int kTrialRays = 16;    // along each axis, a side
constexpr int kRayStride = 99;    // odd, so that all are visited
constexpr int kTrialPoints = 7;   // a side
constexpr double kBeside = 2e-3;  // of the bound: how far from a zero a ray passes that tells a sheet from a thread
constexpr double kSamePoint = 1e-4;
constexpr double kVisible = 1e-3;                // of the bound: half a pixel, or so
constexpr std::int64_t kMostEffort = 8'000'000;  // some tenths of a second

// Where the first of a grid of rays meets it: a formula such as (x − 1)² touches zero without crossing it.
std::optional<glm::dvec3> met_by_rays(const ImplicitSurface& surface, const Stop& stop) {
    const double bound = surface.source().bound;
    formulas::Effort effort{kMostEffort};
    constexpr int kRays = kTrialRays * kTrialRays;
    // In steps through the grid, along all axes in turn: where the effort does not suffice for all they are spread.
    for (int k = 0, i = 0; k < kRays; ++k, i = (i + kRayStride) % kRays)
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            go_on_unless(stop);
            glm::dvec3 from(0.0), along(0.0);
            from[axis] = -2.0 * bound;
            along[axis] = 1.0;
            const int row = i / kTrialRays, column = i % kTrialRays;
            from[(axis + 1) % 3] = bound * (2.0 * (column + 0.5) / kTrialRays - 1.0);
            from[(axis + 2) % 3] = bound * (2.0 * (row + 0.5) / kTrialRays - 1.0);
            if (const auto t = surface.first_hit({{from}, {along}}, &effort)) return from + *t * along;
        }
    return std::nullopt;
}

/// Zeros that no ray of the grid has met, found by going down |f| from all over the ball or cube.
struct Zeros {
    std::vector<glm::dvec3> places;
    bool below = false, above = false;  ///< whether f < 0, or f > 0, was seen anywhere
};

// Not where rounding alone may make it so.
void note_sign(const ImplicitSurface& surface, const glm::dvec3& p, Zeros& zeros) {
    const formulas::Interval f = formulas::value(surface.program(), {p, p});
    if (f.defined == formulas::Interval::Defined::Nowhere) return;
    zeros.below = zeros.below || f.high < 0.0;
    zeros.above = zeros.above || f.low > 0.0;
}

Zeros zeros_of(const ImplicitSurface& surface, const Stop& stop) {
    const double bound = surface.source().bound;
    Zeros zeros;
    for (const glm::dvec3& start : surface.points_throughout(kTrialPoints)) {
        go_on_unless(stop);
        note_sign(surface, start, zeros);
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
        const double coordinate = std::abs(p[i]) < 1e-6 * bound ? 0.0 : p[i];
        text +=
            std::string(i > 0 ? ", " : "") + (coordinate < 0.0 ? "\u2212" : "") + with_digits(std::abs(coordinate), 3);
    }
    return text + ")";
}

// f may be negative within a part far smaller than the grid's cells: down to where two doubles are the same.
void look_around(const ImplicitSurface& surface, Zeros& zeros, const Stop& stop) {
    const double bound = surface.source().bound;
    for (const glm::dvec3& p : zeros.places) {
        go_on_unless(stop);
        for (int step = 0; step < 30; ++step)
            for (int k = 0; k < 8; ++k) {
                const glm::dvec3 side(k & 1 ? 1.0 : -0.9, k & 2 ? 0.8 : -1.0, k & 4 ? 0.9 : -0.8);
                note_sign(surface, p + 1e-2 * std::pow(0.3, step) * bound * side, zeros);
            }
    }
}

constexpr double kRounding = 1e-300;  // of a bound that is 0

// Whether f has one sign throughout, which points alone cannot tell.
bool has_one_sign(const ImplicitSurface& surface) {
    const double bound = surface.source().bound;
    const formulas::Interval f = formulas::value(surface.program(), {glm::dvec3(-bound), glm::dvec3(bound)});
    return f.low >= -kRounding || f.high <= kRounding;
}

std::string thin(const Zeros& zeros, double bound, bool sure) {
    bool one_point = true;
    for (const glm::dvec3& p : zeros.places)
        one_point = one_point && glm::distance(p, zeros.places.front()) < kSamePoint * bound;
    const bool up = zeros.below;
    return std::string("f comes ") + (up ? "up" : "down") + " to 0 " + (one_point ? "at " : "as at ") +
           point_text(zeros.places.front(), bound) + (sure ? " but is never " : " but was nowhere found ") +
           (up ? "positive" : "negative") + (one_point ? ": a point" : ": a line or some points") +
           ", too thin for a surface. Nothing is drawn.";
}

// Where f becomes 0 just where its values end, as sqrt(1 − x²) does.
std::optional<glm::dvec3> zero_at_an_edge(const ImplicitSurface& surface, const Stop& stop) {
    const double step = 2.0 * surface.source().bound / kTrialPoints;
    const auto f = [&](const glm::dvec3& p) { return std::abs(surface.at({p}).value); };
    for (const glm::dvec3& start : surface.points_throughout(kTrialPoints)) {
        go_on_unless(stop);
        for (glm::length_t k = 0; k < 6; ++k) {
            glm::dvec3 in = start, out = start;
            out[k / 2] += k % 2 == 0 ? step : -step;
            if (!(f(in) > 0.0) || !std::isnan(f(out)) || !surface.inside_clip(out)) continue;
            for (int i = 0; i < 60; ++i) {
                const glm::dvec3 middle = 0.5 * (in + out);
                (std::isnan(f(middle)) ? out : in) = middle;
            }
            if (f(in) < 1e-3 * f(start)) return in;
        }
    }
    return std::nullopt;
}

// Of what has triangles.
FormulaNote on_mesh(const ImplicitSurface& surface, const Mesh& mesh) {
    glm::dvec3 low = mesh.positions.front(), high = low;
    for (const glm::dvec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
    const glm::dvec3 sides = high - low;
    const double size = std::max({sides.x, sides.y, sides.z});
    if (size > kVisible * surface.source().bound) return {};
    return {"The surface, around " + point_text(0.5 * (low + high), surface.source().bound) + ", is only " +
            with_digits(size, 2) + " across: too small to be seen within a bound so large. Try a smaller bound."};
}

// Of what has none, but zeros that were found.
FormulaNote on_zeros(const ImplicitSurface& surface, Zeros zeros, const std::string& within, const Stop& stop) {
    const glm::dvec3 first = zeros.places.front();
    formulas::Effort effort{kMostEffort};
    bool sheet = false;
    for (const glm::dvec3& zero : zeros.places) {
        go_on_unless(stop);
        sheet = sheet || is_sheet(surface, zero, effort);
    }
    look_around(surface, zeros, stop);
    if (zeros.below && zeros.above)
        return {"f changes its sign within " + within + ", as at " + point_text(first, surface.source().bound) +
                ", but in parts so thin that only rays find them: there are no triangles, and no arrows."};
    if (sheet)
        return {"f touches 0 within " + within +
                (has_one_sign(surface) ? " without changing its sign" : ", and was not found to change its sign") +
                ". Only rays find such a surface: it has no triangles, and no arrows."};
    return {thin(zeros, surface.source().bound, has_one_sign(surface)), false};
}

bool may_have_zeros_farther_out(const ImplicitSurface& surface) {
    constexpr double kLargestBound = 1e3;
    const formulas::Interval f =
        formulas::value(surface.program(), {glm::dvec3(-kLargestBound), glm::dvec3(kLargestBound)});
    return f.defined != formulas::Interval::Defined::Nowhere && f.contains(0.0) &&
           surface.source().bound < kLargestBound;
}

}  // namespace

FormulaNote note_on(const ImplicitSurface& surface, const Mesh& mesh, const Stop& stop) {
    if (surface.zero_everywhere()) return {"f is 0 everywhere: all of space, and no surface. Nothing is drawn.", false};
    if (!mesh.triangles.empty()) return on_mesh(surface, mesh);
    const std::string within = surface.source().clip == Clip::Ball ? "the ball" : "the cube";
    const FormulaNote none{
        "No zero of f was found within " + within + ", so nothing is drawn. " +
            (may_have_zeros_farther_out(surface) ? "Try a larger bound." : "No larger bound would show one."),
        false};
    if (const auto& p = surface.zero_throughout())
        return {"f is 0 throughout a part of " + within + ", as around " + point_text(*p, surface.source().bound) +
                    ", and changes its sign nowhere: a solid, and no surface. Nothing is drawn.",
                false};
    if (!surface.region() || !surface.close_region()) return none;
    Zeros zeros = zeros_of(surface, stop);
    const bool may_jump = formulas::may_jump(surface.program());
    if (const auto met = met_by_rays(surface, stop); met && (!may_jump || surface.lies_on(*met)))
        zeros.places.insert(zeros.places.begin(), *met);
    if (!zeros.places.empty()) return on_zeros(surface, std::move(zeros), within, stop);
    if (const auto edge = zero_at_an_edge(surface, stop))
        return {"f is 0 only where it stops being defined, as at " + point_text(*edge, surface.source().bound) +
                    ": it changes its sign nowhere within " + within + ". Nothing is drawn.",
                false};
    return none;
}

}  // namespace normalscope

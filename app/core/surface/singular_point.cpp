#include "core/surface/singular_point.h"

#include "core/math/normal_rules.h"
#include "core/surface/singular_neighbours.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace normalscope {

namespace {

// Of the bound.
constexpr double kAround = 0.02;
constexpr double kVanished = 1e-6;  ///< against |∇f| at that distance

bool finite(const glm::dvec3& v) { return std::isfinite(glm::dot(v, v)); }

// Whether ∇f may be zero as near to p as cannot be told from it: bounds know what is steep from what vanishes.
bool may_vanish(const ImplicitSurface& surface, const glm::dvec3& p) {
    const double near = kVanished * kAround * surface.source().bound;
    const formulas::IntervalSample s = formulas::sample(surface.program(), formulas::Box{p - near, p + near});
    return std::ranges::none_of(s.gradient, [](const formulas::Interval& g) { return g.low > 0.0 || g.high < 0.0; });
}
bool has_gradient(const ImplicitSurface& surface, Point<Object> p) {
    return finite(surface.at(p).gradient) && !surface.is_kink(p);
}

// Down f along the sphere, to the curve itself.
glm::dvec3 onto_curve(const ImplicitSurface& surface, const glm::dvec3& centre, double radius, glm::dvec3 direction) {
    for (int k = 0; k < 12; ++k) {
        const formulas::Sample s = surface.at({centre + radius * direction});
        const glm::dvec3 slope = s.gradient - glm::dot(s.gradient, direction) * direction;
        const double slope2 = glm::dot(slope, slope);
        if (!std::isfinite(s.value) || !(slope2 > 0.0)) break;
        direction = glm::normalize(direction - (s.value / (slope2 * radius)) * slope);
    }
    return direction;
}

std::optional<Site> nearest(const ImplicitSurface& surface, const glm::dvec3& centre, const SiteCurves& curves,
                            const glm::dvec3& wanted) {
    const double radius = SingularPoint::kLenders * surface.source().bound;
    std::optional<Site> best;
    double most = -2.0;
    const auto offer = [&](const glm::dvec3& direction, const Site& known) {
        if (!(glm::dot(direction, wanted) > most + 1e-12)) return;
        most = glm::dot(direction, wanted);
        best = known;
    };
    for (const auto& curve : curves)
        for (std::size_t i = 0; i < curve.size(); ++i) {
            const glm::dvec3 a = (curve[i].point.xyz - centre) / radius;
            offer(a, curve[i]);
            if (i + 1 == curve.size()) continue;
            // Between the corners, too: a slider moves it smoothly.
            const glm::dvec3 ab = (curve[i + 1].point.xyz - centre) / radius - a;
            const double s = glm::dot(wanted - a, ab) / glm::dot(ab, ab);
            if (!(s > 0.0 && s < 1.0)) continue;
            const glm::dvec3 d = onto_curve(surface, centre, radius, glm::normalize(a + s * ab));
            const glm::dvec3 g = surface.at({centre + radius * d}).gradient;
            if (finite(g) && glm::dot(g, curve[i].normal.xyz) > 0.0)
                offer(d, {{centre + radius * d}, {glm::normalize(g)}});
        }
    return best;
}

double spread(const SiteCurves& curves) {
    std::vector<glm::dvec3> normals;
    std::size_t count = 0;
    for (const auto& curve : curves) count += curve.size();
    const std::size_t every = 1 + count / 400;
    for (const auto& curve : curves)
        for (std::size_t i = 0; i < curve.size(); i += every) normals.push_back(curve[i].normal.xyz);
    double least = 1.0;
    std::array<glm::dvec3, 2> apart{};
    for (std::size_t i = 0; i < normals.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (const double cosine = glm::dot(normals[i], normals[k]); cosine < least) {
                least = cosine;
                apart = {normals[i], normals[k]};
            }
    return least < 1.0 ? angle_degrees(apart[0], apart[1]).value_or(0.0) : 0.0;
}

}  // namespace

bool is_singular(const ImplicitSurface& surface, Point<Object> p) {
    const glm::dvec3 gradient = surface.at(p).gradient;
    if (gradient == glm::dvec3(0.0) || !has_gradient(surface, p)) return true;
    // Against the smaller side along each axis: beside what grows as an exponential does all else would seem to vanish.
    double around = 0.0;
    const double reach = kAround * surface.source().bound;
    for (glm::length_t i = 0; i < 3; ++i) {
        double smaller = formulas::kInfinity;
        for (const double side : {-reach, reach}) {
            glm::dvec3 q = p.xyz;
            q[i] += side;
            const double length = glm::length(surface.at({q}).gradient);
            if (std::isfinite(length)) smaller = std::min(smaller, length);
        }
        if (std::isfinite(smaller)) around = std::max(around, smaller);
    }
    return glm::length(gradient) < kVanished * around && may_vanish(surface, p.xyz);
}

std::optional<Point<Object>> singular_near(const ImplicitSurface& surface, Point<Object> start, double reach) {
    const double h = 1e-5 * surface.source().bound;
    glm::dvec3 p = start.xyz;
    for (int k = 0; k < 40; ++k) {
        const formulas::Sample s = surface.at({p});
        if (!std::isfinite(s.value) || !finite(s.gradient)) return std::nullopt;
        // Newton's step for ∇f = 0, the second derivatives by differences.
        glm::dmat3 second;
        for (glm::length_t i = 0; i < 3; ++i) {
            glm::dvec3 a = p, b = p;
            a[i] -= h;
            b[i] += h;
            second[i] = (surface.at({b}).gradient - surface.at({a}).gradient) / (2.0 * h);
            if (!finite(second[i])) return std::nullopt;
        }
        // Along a line of singular points one is as good as another: no step in directions that hardly matter.
        const SingularValues parts = singular_values(second);
        const glm::dvec3 along = glm::transpose(parts.u) * s.gradient;
        glm::dvec3 step(0.0);
        for (glm::length_t i = 0; i < 3; ++i)
            if (parts.sigma[i] > 0.02 * parts.sigma.x) step += along[i] / parts.sigma[i] * parts.v[i];
        p -= step;
        if (!finite(p) || !(glm::distance(p, start.xyz) <= reach)) return std::nullopt;
        if (glm::length(step) < 1e-14 * surface.source().bound) break;
    }
    // What is 0 but for rounding is 0.
    const double grain = 1e-9 * surface.source().bound;
    const glm::dvec3 rounded = glm::round(p / grain) * grain + 0.0;
    const Point<Object> found{glm::mix(p, rounded, glm::lessThan(glm::abs(p), glm::dvec3(grain)))};
    const double least = 1e-9 * glm::length(surface.at({p + kAround * surface.source().bound}).gradient);
    if (!is_singular(surface, found) || !(std::abs(surface.at(found).value) <= least * surface.source().bound))
        return std::nullopt;
    return surface.inside_clip(found.xyz) ? std::optional(found) : std::nullopt;
}

std::optional<Site> lender(const ImplicitSurface& surface, Point<Object> p, const Direction<Object>& borrow) {
    return nearest(surface, p.xyz, singular_neighbours(surface, p, SingularPoint::kLenders * surface.source().bound),
                   borrow.vector().xyz);
}

SingularPoint singular_point(const ImplicitSurface& surface, Point<Object> p,
                             const std::optional<Direction<Object>>& borrow) {
    SingularPoint result;
    result.at = p;
    result.undefined = surface.at(p).gradient != glm::dvec3(0.0) && !has_gradient(surface, p);
    for (const auto& curve : singular_neighbours(surface, p, kAsGoodAsLimits * surface.source().bound)) {
        result.fan.emplace_back();
        for (const Site& n : curve) result.fan.back().push_back(n.normal);
    }
    const auto lenders = singular_neighbours(surface, p, SingularPoint::kLenders * surface.source().bound);
    result.spread_degrees = spread(lenders);
    if (borrow) result.lender = nearest(surface, p.xyz, lenders, borrow->vector().xyz);
    return result;
}

}  // namespace normalscope

#include "core/surface/singular_point.h"

#include "core/math/normal_rules.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

// Of the bound.
constexpr double kAsGoodAsLimits = 1e-3;
constexpr double kAround = 0.02;
constexpr double kVanished = 1e-6;  ///< against |∇f| at that distance
constexpr double kOneSheet = 0.05;  ///< against the largest singular value: how far from one sheet it may be
constexpr int kMeridians = 144, kParallels = 72;
constexpr int kHalvings = 50;  // of an edge between them

using Curves = std::vector<std::vector<SingularPoint::Neighbour>>;

bool finite(const glm::dvec3& v) { return std::isfinite(glm::dot(v, v)); }

// The surface's points on a small sphere, curve by curve in order.
class Ring {
public:
    using Neighbour = SingularPoint::Neighbour;

    Ring(const ImplicitSurface& surface, Point<Object> centre, double radius)
        : surface_(surface), centre_(centre.xyz), radius_(radius) {
        values_ = values_in(directions());
        for (int j = 0; j < kParallels; ++j)
            for (int i = 0; i < kMeridians; ++i) {
                const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                                    d = vertex(i, j + 1);
                if (j > 0) add_triangle(a, b, c);
                if (j + 1 < kParallels) add_triangle(a, c, d);
            }
        halve();
        link();
    }

    /// Without what has no normal of its own, as where two sheets cross.
    Curves curves() const {
        double largest = 0.0;
        std::vector<glm::dvec3> gradients;
        for (const glm::dvec3& d : crossings_) {
            gradients.push_back(surface_.at({centre_ + radius_ * d}).gradient);
            if (finite(gradients.back())) largest = std::max(largest, glm::length(gradients.back()));
        }
        Curves result;
        for (const std::vector<std::uint32_t>& chain : chains_) {
            std::vector<Neighbour>* curve = nullptr;
            for (const std::uint32_t k : chain) {
                const glm::dvec3& g = gradients[k];
                if (!finite(g) || !(glm::length(g) > 0.01 * largest)) {
                    curve = nullptr;
                    continue;
                }
                const glm::dvec3 n = glm::normalize(g);
                // From sheet to sheet the normal jumps.
                if (!curve || glm::dot(curve->back().normal.xyz, n) < 0.75) curve = &result.emplace_back();
                curve->push_back({{centre_ + radius_ * crossings_[k]}, {n}});
            }
        }
        return result;
    }

private:
    static std::uint32_t vertex(int i, int j) {
        // One vertex a pole.
        if (j == 0) return 0;
        if (j == kParallels) return 1;
        return static_cast<std::uint32_t>(2 + (j - 1) * kMeridians + i % kMeridians);
    }

    // f in these directions, side by side.
    std::vector<double> values_in(const std::vector<glm::dvec3>& directions) const {
        std::vector<glm::dvec3> points;
        points.reserve(directions.size());
        for (const glm::dvec3& d : directions) points.push_back(centre_ + radius_ * d);
        std::vector<double> values(points.size());
        formulas::values(surface_.program(), points, values);
        return values;
    }

    static std::vector<glm::dvec3> vertices() {
        // Askew: symmetry planes shall not run through rows of vertices.
        const glm::dvec3 up = glm::normalize(glm::dvec3(0.3141, 0.9, 0.1618)),
                         u = glm::normalize(glm::cross(up, glm::dvec3(0.2718, 0.0577, 1.0))), v = glm::cross(up, u);
        std::vector<glm::dvec3> directions{up, -up};
        for (int j = 1; j < kParallels; ++j)
            for (int i = 0; i < kMeridians; ++i) {
                const double a = glm::two_pi<double>() * i / kMeridians, e = glm::pi<double>() * j / kParallels;
                directions.push_back(std::cos(e) * up + std::sin(e) * (std::cos(a) * u + std::sin(a) * v));
            }
        return directions;
    }
    static const std::vector<glm::dvec3>& directions() {
        static const std::vector<glm::dvec3> same_for_all = vertices();
        return same_for_all;
    }

    // Where the curve crosses an edge of the sphere's net, whose ends have different signs; where along it, halve() says.
    std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
        if (a > b) std::swap(a, b);
        const auto [it, is_new] =
            known_.try_emplace(std::uint64_t{a} << 32 | b, static_cast<std::uint32_t>(crossed_.size()));
        if (!is_new) return it->second;
        crossed_.push_back({a, b});
        neighbours_.push_back({});
        return it->second;
    }

    // All edges that are crossed at once.
    void halve() {
        std::vector<glm::dvec3> from, to, middles(crossed_.size());
        for (const auto& [a, b] : crossed_) {
            from.push_back(directions()[a]);
            to.push_back(directions()[b]);
        }
        for (int i = 0; i < kHalvings; ++i) {
            for (std::size_t k = 0; k < crossed_.size(); ++k) middles[k] = glm::normalize(from[k] + to[k]);
            const std::vector<double> values = values_in(middles);
            for (std::size_t k = 0; k < crossed_.size(); ++k)
                ((values[k] < 0.0) == (values_[crossed_[k].first] < 0.0) ? from : to)[k] = middles[k];
        }
        for (std::size_t k = 0; k < crossed_.size(); ++k) crossings_.push_back(glm::normalize(from[k] + to[k]));
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (!std::isfinite(values_[a]) || !std::isfinite(values_[b]) || !std::isfinite(values_[c])) return;
        const bool at_a = values_[a] < 0.0, at_b = values_[b] < 0.0, at_c = values_[c] < 0.0;
        if (at_a == at_b && at_b == at_c) return;
        std::array<std::uint32_t, 2> ends{};
        std::size_t count = 0;
        if (at_a != at_b) ends[count++] = crossing(a, b);
        if (at_b != at_c) ends[count++] = crossing(b, c);
        if (at_c != at_a) ends[count++] = crossing(c, a);
        neighbours_[ends[0]].push_back(ends[1]);
        neighbours_[ends[1]].push_back(ends[0]);
    }

    void link() {
        std::vector<bool> used(crossings_.size(), false);
        const auto follow = [&](std::uint32_t k) {
            std::vector<std::uint32_t>& chain = chains_.emplace_back();
            const std::uint32_t first = k;
            for (bool on = true; on;) {
                used[k] = true;
                chain.push_back(k);
                on = false;
                for (const std::uint32_t next : neighbours_[k])
                    if (!used[next] && !on) k = next, on = true;
            }
            if (chain.size() > 2 && std::ranges::count(neighbours_[k], first) > 0) chain.push_back(first);
        };
        for (const std::size_t most : {1u, 2u})  // open ends first
            for (std::uint32_t k = 0; k < crossings_.size(); ++k)
                if (!used[k] && neighbours_[k].size() <= most) follow(k);
    }

    const ImplicitSurface& surface_;
    glm::dvec3 centre_;
    double radius_;
    std::vector<double> values_;
    std::unordered_map<std::uint64_t, std::uint32_t> known_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> crossed_;  // the ends of the edges that are crossed
    std::vector<glm::dvec3> crossings_;
    std::vector<std::vector<std::uint32_t>> neighbours_;
    std::vector<std::vector<std::uint32_t>> chains_;
};

// Where f touches 0 without changing its sign, as a square does, the sphere has no such curves. Over and under such a
// sheet ∇f points away from it, or towards it, on either side: so the differences of ∇f across the point, one for each
// axis, are all along one line, the sheet's normal.
Curves above_and_below(const ImplicitSurface& surface, Point<Object> p, double radius) {
    glm::dmat3 differences;
    for (glm::length_t i = 0; i < 3; ++i) {
        glm::dvec3 step(0.0);
        step[i] = kAsGoodAsLimits * surface.source().bound;
        differences[i] = surface.at({p.xyz + step}).gradient - surface.at({p.xyz - step}).gradient;
        if (!finite(differences[i])) return {};
    }
    const SingularValues parts = singular_values(differences);
    if (!(parts.sigma.y < kOneSheet * parts.sigma.x)) return {};
    Curves sides;
    for (const double side : {1.0, -1.0}) {
        const glm::dvec3 at = p.xyz + side * radius * parts.u[0], g = surface.at({at}).gradient;
        if (finite(g) && glm::length(g) > 0.0) sides.push_back({{{at}, {glm::normalize(g)}}});
    }
    return sides;
}

Curves found_neighbours(const ImplicitSurface& surface, Point<Object> p, double radius) {
    auto curves = Ring(surface, p, radius).curves();
    return curves.empty() ? above_and_below(surface, p, radius) : curves;
}

// The same few are asked for in frame after frame, while only the camera or M moves.
Curves neighbours(const ImplicitSurface& surface, Point<Object> p, double radius) {
    struct Known {
        FormulaSurface source;
        glm::dvec3 p;
        double radius;
        Curves curves;
    };
    constexpr std::size_t kMost = 4;
    static thread_local std::deque<Known> known;
    const auto found = std::ranges::find_if(
        known, [&](const Known& k) { return k.p == p.xyz && k.radius == radius && k.source == surface.source(); });
    if (found != known.end()) return found->curves;
    if (known.size() == kMost) known.pop_front();
    known.push_back({surface.source(), p.xyz, radius, found_neighbours(surface, p, radius)});
    return known.back().curves;
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

std::optional<SingularPoint::Neighbour> nearest(const ImplicitSurface& surface, const glm::dvec3& centre,
                                                const Curves& curves, const glm::dvec3& wanted) {
    const double radius = SingularPoint::kLenders * surface.source().bound;
    std::optional<SingularPoint::Neighbour> best;
    double most = -2.0;
    const auto offer = [&](const glm::dvec3& direction, const SingularPoint::Neighbour& known) {
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

double spread(const Curves& curves) {
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
    if (!finite(gradient) || gradient == glm::dvec3(0.0)) return true;
    double around = 0.0;
    const double reach = kAround * surface.source().bound;
    for (glm::length_t i = 0; i < 3; ++i)
        for (const double side : {-reach, reach}) {
            glm::dvec3 q = p.xyz;
            q[i] += side;
            const double length = glm::length(surface.at({q}).gradient);
            if (std::isfinite(length)) around = std::max(around, length);
        }
    return glm::length(gradient) < kVanished * around;
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

std::optional<SingularPoint::Neighbour> lender(const ImplicitSurface& surface, Point<Object> p,
                                               const Direction<Object>& borrow) {
    return nearest(surface, p.xyz, neighbours(surface, p, SingularPoint::kLenders * surface.source().bound),
                   borrow.vector().xyz);
}

SingularPoint singular_point(const ImplicitSurface& surface, Point<Object> p,
                             const std::optional<Direction<Object>>& borrow) {
    SingularPoint result;
    result.at = p;
    result.undefined = !finite(surface.at(p).gradient);
    for (const auto& curve : neighbours(surface, p, kAsGoodAsLimits * surface.source().bound)) {
        result.fan.emplace_back();
        for (const SingularPoint::Neighbour& n : curve) result.fan.back().push_back(n.normal);
    }
    const auto lenders = neighbours(surface, p, SingularPoint::kLenders * surface.source().bound);
    result.spread_degrees = spread(lenders);
    if (borrow) result.lender = nearest(surface, p.xyz, lenders, borrow->vector().xyz);
    return result;
}

}  // namespace normalscope

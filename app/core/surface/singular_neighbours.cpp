#include "core/surface/singular_neighbours.h"

#include "core/math/normal_rules.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>

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

constexpr double kOneSheet = 0.05;  // against the largest singular value: how far from one sheet it may be
constexpr int kMeridians = 144, kParallels = 72;
constexpr int kHalvings = 50;  // of an edge between them

bool finite(const glm::dvec3& v) { return std::isfinite(glm::dot(v, v)); }

// The surface's points on a small sphere, curve by curve in order.
class SphereCut {
public:
    SphereCut(const ImplicitSurface& surface, Point<Object> centre, double radius)
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
    SiteCurves curves() const {
        double largest = 0.0;
        std::vector<glm::dvec3> gradients;
        for (const glm::dvec3& d : crossings_) {
            gradients.push_back(surface_.at({centre_ + radius_ * d}).gradient);
            if (finite(gradients.back())) largest = std::max(largest, glm::length(gradients.back()));
        }
        SiteCurves result;
        for (const std::vector<std::uint32_t>& chain : chains_) {
            std::vector<Site>* curve = nullptr;
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
        // Askew: symmetry planes must not run through rows of vertices.
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
SiteCurves above_and_below(const ImplicitSurface& surface, Point<Object> p, double radius) {
    glm::dmat3 differences;
    for (glm::length_t i = 0; i < 3; ++i) {
        glm::dvec3 step(0.0);
        step[i] = kAsGoodAsLimits * surface.source().bound;
        differences[i] = surface.at({p.xyz + step}).gradient - surface.at({p.xyz - step}).gradient;
        if (!finite(differences[i])) return {};
    }
    const SingularValues parts = singular_values(differences);
    if (!(parts.sigma.y < kOneSheet * parts.sigma.x)) return {};
    SiteCurves sides;
    for (const double side : {1.0, -1.0}) {
        const glm::dvec3 at = p.xyz + side * radius * parts.u[0], g = surface.at({at}).gradient;
        if (finite(g) && glm::length(g) > 0.0) sides.push_back({{{at}, {glm::normalize(g)}}});
    }
    return sides;
}

SiteCurves found_neighbours(const ImplicitSurface& surface, Point<Object> p, double radius) {
    auto curves = SphereCut(surface, p, radius).curves();
    return curves.empty() ? above_and_below(surface, p, radius) : curves;
}

}  // namespace

// The same few are asked for in frame after frame, while only the camera or M moves.
SiteCurves singular_neighbours(const ImplicitSurface& surface, Point<Object> p, double radius) {
    struct Known {
        FormulaSurface source;
        glm::dvec3 p;
        double radius;
        SiteCurves curves;
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

}  // namespace normalscope

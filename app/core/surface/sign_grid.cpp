#include "core/surface/sign_grid.h"

#include "core/program/points_in_parts.h"
#include "core/surface/stopped.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace normalscope {

SignGrid::SignGrid(const ImplicitSurface& surface, const formulas::Box& box, const glm::dvec3& step, const Stop& stop)
    : surface_(surface),
      stop_(stop),
      low_(box.low),
      step_(step),
      counts_(glm::max(glm::ivec3(glm::ceil((box.high - box.low) / step - 1e-9)), 1)) {
    std::vector<glm::dvec3> points;
    points.reserve(index(counts_) + 1);
    each_corner([&](const glm::ivec3& c) { points.push_back(corner(c)); });
    values_.resize(points.size());
    formulas::values(surface.program(), points, values_);
}

bool SignGrid::has_both_signs() const {
    return std::ranges::any_of(values_, [](double f) { return f < 0.0; }) &&
           std::ranges::any_of(values_, [](double f) { return f > 0.0; });
}

bool SignGrid::changes_sign(const Edge& e) const {
    glm::ivec3 end = e.from;
    if (++end[e.axis] > counts_[e.axis]) return false;
    const double here = value(e.from), there = value(end);
    return !std::isnan(here) && !std::isnan(there) && (here < 0.0) != (there < 0.0);
}

formulas::Edge SignGrid::ends(const Edge& e) const {
    glm::ivec3 end = e.from;
    ++end[e.axis];
    return {corner(e.from), corner(end)};
}

std::vector<SignGrid::Edge> SignGrid::crossed_edges() const {
    std::vector<Edge> edges;
    for (glm::length_t axis = 0; axis < 3; ++axis)
        each_corner([&](const glm::ivec3& c) {
            if (const Edge edge{c, axis}; changes_sign(edge)) edges.push_back(edge);
        });
    return edges;
}

double SignGrid::crossing(const Edge& e) {
    const auto [known, is_new] = crossings_.try_emplace(key(e), std::nan(""));
    if (!is_new) return known->second;
    go_on_unless(stop_);
    const auto [a, b] = ends(e);
    return known->second = formulas::zero_between(surface_.program(), a, b).value_or(std::nan(""));
}

void SignGrid::find_crossings(const std::vector<Edge>& wanted) {
    constexpr std::size_t kAtOnce = 512, kTimes = 50;  // as often, or so, f is computed for each
    std::vector<formulas::Edge> edges;
    std::vector<std::size_t> keys;
    for (const Edge& e : wanted) {
        if (!crossings_.try_emplace(key(e), std::nan("")).second) continue;
        edges.push_back(ends(e));
        keys.push_back(key(e));
    }
    std::vector<std::optional<double>> zeros(edges.size());
    const auto find = [&](std::size_t begin, std::size_t end) {
        for (; begin < end; begin += kAtOnce) {
            go_on_unless(stop_);
            const std::size_t count = std::min(kAtOnce, end - begin);
            std::ranges::copy(formulas::zeros_between(surface_.program(), std::span(edges).subspan(begin, count)),
                              zeros.begin() + static_cast<std::ptrdiff_t>(begin));
        }
    };
    formulas::points_in_parts(surface_.program(), edges.size(), 1, find, kTimes);
    for (std::size_t k = 0; k < keys.size(); ++k) crossings_[keys[k]] = zeros[k].value_or(std::nan(""));
}

}  // namespace normalscope

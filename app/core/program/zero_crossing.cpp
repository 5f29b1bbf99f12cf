#include "core/program/zero_crossing.h"

#include "core/program/evaluate.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace normalscope::formulas {

namespace {

constexpr int kMostHalvings = 64;

// What rounding alone may make of 0 there.
bool as_good_as_zero(const Program& program, const glm::dvec3& p) {
    const Interval v = value(program, Box{p, p});
    return v.defined == Interval::Defined::Everywhere && std::isfinite(v.width()) && v.low <= 4.0 * v.width() &&
           v.high >= -4.0 * v.width();
}

bool continuous(const Program& program, const glm::dvec3& a, const glm::dvec3& b) {
    const Interval v = value(program, Box{glm::min(a, b), glm::max(a, b)});
    return v.defined == Interval::Defined::Everywhere && std::isfinite(v.width());
}

}  // namespace

bool may_jump(const Program& program) {
    return std::ranges::any_of(program, [&](const Instruction& i) {
        if (!i.varies) return false;
        switch (i.code) {
            case Code::Divide: return program[i.b].varies;
            case Code::IntegerPower:
            case Code::RealPower: return i.constant < 0.0;
            case Code::Power:
            case Code::Tan:
            case Code::Sign:
            case Code::Floor:
            case Code::Atan2:
            case Code::Where: return true;
            default: return false;
        }
    });
}

namespace {

// Side by side, where there are enough of them for that.
void evaluate(const Program& program, std::span<const glm::dvec3> points, std::span<double> f) {
    if (points.size() > 2) return values(program, points, f);
    for (std::size_t k = 0; k < points.size(); ++k) f[k] = value(program, points[k]);
}

// On the way to a zero between the ends of an edge, by halves.
struct Search {
    double low = 0.0, high = 1.0, f_low = 0.0, f_high = 0.0;
    bool falling = false, gap = false, done = false;
    std::vector<double> sizes;

    void step(double s, double v) {
        ((v < 0.0) == falling ? high : low) = s;
        ((v < 0.0) == falling ? f_high : f_low) = v;
    }
};

// At a zero |f| becomes smaller and smaller on both sides, be it as slowly as a ninth root. At a pole it grows, at a jump it stays.
std::optional<double> found(const Program& program, const Edge& edge, const Search& search) {
    const auto at = [&](double s) { return glm::mix(edge.a, edge.b, s); };
    const std::vector<double>& sizes = search.sizes;
    if (search.gap) return std::nullopt;
    if (sizes.back() <= 0.5 * sizes[sizes.size() / 2] || continuous(program, edge.a, edge.b) ||
        (as_good_as_zero(program, at(search.low)) && as_good_as_zero(program, at(search.high))))
        return 0.5 * (search.low + search.high);
    return std::nullopt;
}

}  // namespace

std::vector<std::optional<double>> zeros_between(const Program& program, std::span<const Edge> edges) {
    std::vector<Search> searches(edges.size());
    std::vector<glm::dvec3> points;
    for (const Edge& edge : edges) points.insert(points.end(), {edge.a, edge.b});
    std::vector<double> f(points.size());
    evaluate(program, points, f);
    for (std::size_t k = 0; k < edges.size(); ++k) {
        searches[k].f_low = f[2 * k];
        searches[k].f_high = f[2 * k + 1];
        searches[k].falling = searches[k].f_high < 0.0;
    }
    std::vector<std::size_t> open;
    for (int i = 0; i < kMostHalvings; ++i) {
        open.clear();
        points.clear();
        for (std::size_t k = 0; k < edges.size(); ++k) {
            Search& search = searches[k];
            if (search.done) continue;
            search.sizes.push_back(std::max(std::abs(search.f_low), std::abs(search.f_high)));
            const auto at = [&](double s) { return glm::mix(edges[k].a, edges[k].b, s); };
            const glm::dvec3 middle = at(0.5 * (search.low + search.high));
            search.done = middle == at(search.low) || middle == at(search.high);
            if (search.done) continue;
            open.push_back(k);
            points.push_back(middle);
        }
        f.resize(points.size());
        evaluate(program, points, f);
        for (std::size_t j = 0; j < open.size(); ++j) {
            Search& search = searches[open[j]];
            double s = 0.5 * (search.low + search.high), v = f[j];
            if (std::isnan(v)) {  // a pole was met by chance
                s = search.low + 0.4142 * (search.high - search.low);
                v = value(program, glm::mix(edges[open[j]].a, edges[open[j]].b, s));
            }
            search.gap = search.done = std::isnan(v);
            if (!search.gap) search.step(s, v);
        }
    }
    std::vector<std::optional<double>> zeros;
    for (std::size_t k = 0; k < edges.size(); ++k) zeros.push_back(found(program, edges[k], searches[k]));
    return zeros;
}

std::optional<double> zero_between(const Program& program, const glm::dvec3& a, const glm::dvec3& b) {
    const Edge edge{a, b};
    return zeros_between(program, {&edge, 1}).front();
}

}  // namespace normalscope::formulas

#include "core/surface/level_sets.h"

#include "core/program/zero_crossing.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace normalscope {

namespace {

constexpr int kCells = 144;      // a side
constexpr int kSquare = 4;       // so many of them a side are drawn as one square at most
constexpr double kFlat = 0.004;  // of the step between levels: this much f may differ there from what its corners say
constexpr int kArrowsASide = 9;  // at most; those outside the ball are left out
constexpr double kShareOfBands = 0.7;  // of the plane: so much of it lies within the first four levels on either side

struct Corner {
    glm::dvec2 at{0.0};
    double f = 0.0;
};
using Polygon = std::vector<Corner>;

// 1, 2 or 5 times a power of ten, at least `size`.
double round_step(double size) {
    const double power = std::pow(10.0, std::floor(std::log10(size)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= size * (1.0 - 1e-9)) return digit * power;
    return 10.0 * power;
}

Corner between(const Corner& a, const Corner& b, double s) { return {glm::mix(a.at, b.at, s), a.f + s * (b.f - a.f)}; }

// The part of a convex polygon where `above` (linear between the corners) is not negative (Sutherland and Hodgman, 1974).
template <class F>
Polygon clipped(const Polygon& polygon, F&& above) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double fa = above(a), fb = above(b);
        if (fa >= 0.0) result.push_back(a);
        if ((fa >= 0.0) != (fb >= 0.0)) result.push_back(between(a, b, fa / (fa - fb)));
    }
    return result;
}

class Maker {
public:
    Maker(const ImplicitSurface& surface, const Slice& slice, Detail detail)
        : surface_(surface),
          square_(detail == Detail::Bands ? kSquare : 1),
          may_jump_(formulas::may_jump(surface.written_program())) {
        const auto axis = static_cast<glm::length_t>(slice.axis);
        // So that (u, v, axis) is right-handed, and the plane looks as one draws it.
        sets_.across[0][(axis + 1) % 3] = 1.0;
        sets_.across[1][(axis + 2) % 3] = 1.0;
        sets_.middle[axis] = slice.at;
        const double bound = surface.source().bound;
        round_ = surface.source().clip == Clip::Ball;
        const double left = bound * bound - slice.at * slice.at;
        sets_.reach = round_ ? std::sqrt(std::max(left, 0.0)) : std::abs(slice.at) <= bound ? bound : 0.0;
    }

    LevelSets make(bool gradient) {
        if (!(sets_.reach > 1e-6 * surface_.source().bound)) return sets_;
        evaluate();
        choose_step();
        if (sets_.step == 0.0) return sets_;
        for (int j = 0; j < kCells; j += square_) add_row(j);
        name_sides();
        if (gradient) add_gradients();
        return std::move(sets_);
    }

private:
    glm::dvec3 lift(glm::dvec2 at) const { return sets_.middle + at.x * sets_.across[0] + at.y * sets_.across[1]; }
    glm::dvec2 place(int i, int j) const { return sets_.reach * (2.0 / kCells * glm::dvec2(i, j) - glm::dvec2(1.0)); }
    const Corner& corner(int i, int j) const {
        return corners_[static_cast<std::size_t>(j) * (kCells + 1) + static_cast<std::size_t>(i)];
    }
    // In the ball: not negative.
    double within(const Corner& c) const { return round_ ? sets_.reach * sets_.reach - glm::dot(c.at, c.at) : 1.0; }
    int band_of(double f) const {
        return static_cast<int>(
            std::clamp(std::floor(f / sets_.step), -1.0 * LevelSets::kMostBands, LevelSets::kMostBands - 1.0));
    }
    Corner evaluated(glm::dvec2 at) const {
        return {at, usable(formulas::value(surface_.written_program(), lift(at)))};
    }
    static double usable(double f) { return std::abs(f) < 1e100 ? f : std::nan(""); }

    void evaluate() {
        std::vector<glm::dvec3> points;
        for (int j = 0; j <= kCells; ++j)
            for (int i = 0; i <= kCells; ++i) {
                corners_.push_back({place(i, j), 0.0});
                points.push_back(lift(corners_.back().at));
            }
        std::vector<double> values(points.size());
        formulas::values(surface_.written_program(), points, values);
        for (std::size_t k = 0; k < values.size(); ++k) corners_[k].f = usable(values[k]);
    }

    void choose_step() {
        std::vector<double> sizes;
        for (const Corner& c : corners_)
            if (within(c) >= 0.0 && !std::isnan(c.f)) sizes.push_back(std::abs(c.f));
        if (sizes.empty()) return;
        const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(kShareOfBands * static_cast<double>(sizes.size()));
        std::nth_element(sizes.begin(), at, sizes.end());
        double size = *at / 4.0;
        if (size == 0.0) size = *std::max_element(sizes.begin(), sizes.end()) / 4.0;
        if (size > 1e-100) sets_.step = round_step(size);
    }

    // Squares of cells, as large as they may be. Those of one band next to each other are drawn as one.
    void add_row(int j) {
        int from = 0;
        std::optional<int> band;
        for (int i = 0; i <= kCells; i += square_) {
            std::optional<int> here;
            if (i < kCells) here = whole_band(i, j, square_);
            if (here != band) {
                if (band) add_quad(place(from, j), place(i, j + square_), *band);
                from = i;
                band = here;
            }
            if (i < kCells && !here) add_square(i, j, square_);
        }
    }

    void add_square(int i, int j, int size) {
        if (const auto band = whole_band(i, j, size)) return add_quad(place(i, j), place(i + size, j + size), *band);
        const Corner &a = corner(i, j), &b = corner(i + size, j), &c = corner(i + size, j + size),
                     &d = corner(i, j + size);
        if (square_ > 1 && is_plain(i, j, size)) return add_polygon({a, b, c, d});
        if (size > 1) {
            const int half = size / 2;
            for (const auto& [di, dj] : {std::array{0, 0}, {half, 0}, {0, half}, {half, half}})
                add_square(i + di, j + dj, half);
        } else if ((i + j) % 2 == 0) {  // diagonals towards the middle and away in turn: no direction is preferred
            add_polygon({a, b, c});
            add_polygon({a, c, d});
        } else {
            add_polygon({a, b, d});
            add_polygon({b, c, d});
        }
    }

    std::optional<int> whole_band(int i, int j, int size) const {
        std::optional<int> band;
        for (int l = j; l <= j + size; ++l)
            for (int k = i; k <= i + size; ++k) {
                const Corner& c = corner(k, l);
                if (std::isnan(c.f) || within(c) < 0.0) return std::nullopt;
                if (band && *band != band_of(c.f)) return std::nullopt;
                band = band_of(c.f);
            }
        return band;
    }

    // As good as known from its corners, and a level that enters it leaves it once: no saddle.
    bool is_plain(int i, int j, int size) const {
        const std::array<double, 4> f{corner(i, j).f, corner(i + size, j).f, corner(i + size, j + size).f,
                                      corner(i, j + size).f};
        for (int l = j; l <= j + size; ++l)
            for (int k = i; k <= i + size; ++k) {
                const Corner& c = corner(k, l);
                if (std::isnan(c.f) || within(c) < 0.0) return false;
                const double x = static_cast<double>(k - i) / size, y = static_cast<double>(l - j) / size;
                const double flat = (1.0 - y) * std::lerp(f[0], f[1], x) + y * std::lerp(f[3], f[2], x);
                if (!(std::abs(c.f - flat) <= kFlat * sets_.step)) return false;
            }
        const auto [low, high] = std::ranges::minmax(f);
        if (high - low > 2.0 * sets_.step) return false;
        for (int level = band_of(low); level <= band_of(high) + 1; ++level) {
            int crossed = 0;
            for (std::size_t k = 0; k < 4; ++k)
                crossed += (f[k] < level * sets_.step) != (f[(k + 1) % 4] < level * sets_.step) ? 1 : 0;
            if (crossed > 2) return false;
        }
        return true;
    }

    void add_quad(glm::dvec2 low, glm::dvec2 high, int band) {
        const glm::dvec3 a = lift(low), b = lift({high.x, low.y}), c = lift(high), d = lift({low.x, high.y});
        sets_.patches.push_back({{a, b, c}, band});
        sets_.patches.push_back({{a, c, d}, band});
    }

    // What is left of a polygon where f has no value at some corners: up to the last point of each edge that has one.
    Polygon defined_part(const Polygon& polygon) const {
        Polygon result;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const bool has_a = !std::isnan(a.f), has_b = !std::isnan(b.f);
            if (has_a) result.push_back(a);
            if (has_a == has_b) continue;
            Corner good = has_a ? a : b;
            glm::dvec2 bad = has_a ? b.at : a.at;
            for (int k = 0; k < 20; ++k) {
                const Corner c = evaluated(0.5 * (good.at + bad));
                if (std::isnan(c.f))
                    bad = c.at;
                else
                    good = c;
            }
            result.push_back(good);
        }
        return result;
    }

    // A triangle, or a square that is plain.
    void add_polygon(const Polygon& polygon) {
        const auto [low, high] = std::minmax({polygon[0].f, polygon[1].f, polygon[2].f});
        if (high - low > 2.0 * sets_.step) {
            // Over a pole f jumps from −∞ to ∞ without having the values between.
            const double f = evaluated((polygon[0].at + polygon[1].at + polygon[2].at) / 3.0).f;
            if (std::isnan(f) || f < low || f > high) return;
        }
        const Polygon whole = clipped(defined_part(polygon), [&](const Corner& c) { return within(c); });
        if (whole.size() < 3) return;
        double least = whole.front().f, most = least;
        for (const Corner& c : whole) least = std::min(least, c.f), most = std::max(most, c.f);
        for (int band = band_of(least); band <= band_of(most); ++band) {
            Polygon part = whole;
            if (band > -LevelSets::kMostBands)
                part = clipped(part, [&](const Corner& c) { return c.f - band * sets_.step; });
            if (band < LevelSets::kMostBands - 1)
                part = clipped(part, [&](const Corner& c) { return (band + 1) * sets_.step - c.f; });
            for (std::size_t i = 2; i < part.size(); ++i)
                sets_.patches.push_back({{lift(part[0].at), lift(part[i - 1].at), lift(part[i].at)}, band});
            if (band > band_of(least)) add_line(whole, band);
        }
    }

    void add_line(const Polygon& polygon, int level) {
        std::vector<glm::dvec3> ends;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double fa = a.f - level * sets_.step, fb = b.f - level * sets_.step;
            if ((fa < 0.0) == (fb < 0.0)) continue;
            // Over a jump, as over a pole, f is not 0: no line of the surface.
            if (level == 0 && may_jump_ && !formulas::zero_between(surface_.written_program(), lift(a.at), lift(b.at)))
                return;
            ends.push_back(lift(between(a, b, fa / (fa - fb)).at));
        }
        if (ends.size() == 2) sets_.lines.push_back({{ends[0], ends[1]}, level});
    }

    // Rosenfeld and Pfaltz's distance transform (1966), with 5 and 7 for 1 and √2.
    void name_sides() {
        constexpr int kSide = kCells + 1;
        for (const bool inside : {true, false}) {
            std::vector<int> distance(corners_.size(), 0);
            const auto relax = [&](int i, int j, int di, int dj, int cost) {
                int& here = distance[static_cast<std::size_t>(j) * kSide + static_cast<std::size_t>(i)];
                const int k = i + di, l = j + dj;
                const bool out = k < 0 || l < 0 || k >= kSide || l >= kSide;
                here = std::min(
                    here,
                    cost + (out ? 0 : distance[static_cast<std::size_t>(l) * kSide + static_cast<std::size_t>(k)]));
            };
            for (std::size_t k = 0; k < corners_.size(); ++k)
                if (within(corners_[k]) >= 0.0 && (inside ? corners_[k].f < 0.0 : corners_[k].f > 0.0))
                    distance[k] = 1 << 20;
            for (int j = 0; j < kSide; ++j)
                for (int i = 0; i < kSide; ++i)
                    for (const auto& [di, dj, cost] : {std::array{-1, 0, 5}, {0, -1, 5}, {-1, -1, 7}, {1, -1, 7}})
                        relax(i, j, di, dj, cost);
            for (int j = kSide - 1; j >= 0; --j)
                for (int i = kSide - 1; i >= 0; --i)
                    for (const auto& [di, dj, cost] : {std::array{1, 0, 5}, {0, 1, 5}, {1, 1, 7}, {-1, 1, 7}})
                        relax(i, j, di, dj, cost);
            std::optional<std::size_t> best;
            double most = 10.0;  // two cells: no room for a word
            for (std::size_t k = 0; k < corners_.size(); ++k) {
                // Of many as good, as around a ball, one to the right and above.
                const double score = distance[k] + 2.0 * glm::dot(corners_[k].at, glm::dvec2(0.8, 0.6)) / sets_.reach;
                if (distance[k] > 10 && score > most) best = k, most = score;
            }
            if (best) (inside ? sets_.inside : sets_.outside) = lift(corners_[*best].at);
        }
    }

    void add_gradients() {
        std::vector<glm::dvec3> points;
        for (int j = 0; j < kArrowsASide; ++j)
            for (int i = 0; i < kArrowsASide; ++i) {
                const glm::dvec2 at = sets_.reach * (2.0 / kArrowsASide * (glm::dvec2(i, j) + 0.5) - glm::dvec2(1.0));
                if (within({at, 0.0}) >= 0.0) points.push_back(lift(at));
            }
        std::vector<formulas::Sample> samples(points.size());
        formulas::samples(surface_.written_program(), points, samples);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double length = glm::length(samples[k].gradient);
            if (std::isfinite(samples[k].value) && length > 1e-100 && length < 1e100)
                sets_.gradients.push_back({{points[k]}, {samples[k].gradient}});
        }
    }

    const ImplicitSurface& surface_;
    int square_;  // so many cells a side are drawn as one at most
    bool may_jump_;
    bool round_ = true;
    LevelSets sets_;
    std::vector<Corner> corners_;
};

}  // namespace

LevelSets level_sets(const ImplicitSurface& surface, const Slice& slice, Detail detail) {
    return Maker(surface, slice, detail).make(slice.gradient);
}

std::shared_ptr<const LevelSets> level_sets(const Scene& scene, const ImplicitSurface* surface) {
    if (!scene.slice || !surface) return nullptr;
    return std::make_shared<const LevelSets>(level_sets(*surface, *scene.slice));
}

std::shared_ptr<const LevelSets> LevelSetsCache::get(const Scene& scene,
                                                     const std::shared_ptr<const ImplicitSurface>& surface) {
    if (!scene.slice || !surface) return nullptr;
    if (!sets_ || surface_ != surface || slice_ != scene.slice) {
        surface_ = surface;
        slice_ = scene.slice;
        sets_ = level_sets(scene, surface.get());
    }
    return sets_;
}

}  // namespace normalscope

#include "core/surface/curves_joined.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace normalscope {

namespace {

/// Numbers places, the same for all that are near each other.
class Places {
public:
    explicit Places(double near) : near_(near) {}

    std::size_t number(const glm::dvec3& p) {
        const Cell cell = cell_of(p);
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j) {
                const auto [from, to] = cells_.equal_range({cell.first + i, cell.second + j});
                for (auto known = from; known != to; ++known)
                    if (glm::distance(places_[known->second], p) <= near_) return known->second;
            }
        cells_.emplace(cell, places_.size());
        places_.push_back(p);
        return places_.size() - 1;
    }
    std::size_t count() const { return places_.size(); }

private:
    using Cell = std::pair<std::int64_t, std::int64_t>;
    Cell cell_of(const glm::dvec3& p) const {
        const double side = 2.0 * near_;
        return {std::llround(std::floor(p.x / side)), std::llround(std::floor(p.y / side))};
    }

    double near_;
    std::vector<glm::dvec3> places_;
    std::multimap<Cell, std::size_t> cells_;
};

class Joiner {
public:
    Joiner(const std::vector<CurvePiece>& pieces, double near) {
        Places places(near);
        for (const CurvePiece& piece : pieces) {
            const std::array ends{places.number(piece.from.point.xyz), places.number(piece.to.point.xyz)};
            if (ends[0] == ends[1]) continue;
            pieces_.push_back(piece);
            ends_.push_back(ends);
        }
        at_.resize(places.count());
        for (std::size_t i = 0; i < ends_.size(); ++i)
            for (const std::size_t end : ends_[i]) at_[end].push_back(i);
        taken_.resize(pieces_.size(), false);
    }

    std::vector<Curve> curves() {
        std::vector<Curve> result;
        // From open ends first: what is left then goes round.
        for (const bool open : {true, false})
            for (std::size_t i = 0; i < pieces_.size(); ++i)
                for (const std::size_t start : ends_[i])
                    if (!taken_[i] && (!open || at_[start].size() == 1)) result.push_back(curve_from(i, start));
        return result;
    }

private:
    Curve curve_from(std::size_t first, std::size_t start) {
        Curve curve;
        std::size_t at = start;
        for (std::optional<std::size_t> next = first; next; next = straightest(at, curve.pieces.back())) {
            taken_[*next] = true;
            CurvePiece piece = pieces_[*next];
            const auto& [from, to] = ends_[*next];
            if (from != at) std::swap(piece.from, piece.to);
            at = from == at ? to : from;
            curve.pieces.push_back(piece);
            if (at == start) break;
        }
        curve.closed = at == start;
        return curve;
    }

    std::optional<std::size_t> straightest(std::size_t at, const CurvePiece& last) const {
        const auto way = [](const CurvePiece& piece) {
            return glm::normalize(piece.to.point.xyz - piece.from.point.xyz);
        };
        std::optional<std::size_t> best;
        double most = -2.0;
        for (const std::size_t i : at_[at]) {
            if (taken_[i]) continue;
            const double along = (ends_[i][0] == at ? 1.0 : -1.0) * glm::dot(way(last), way(pieces_[i]));
            if (along > most) best = i, most = along;
        }
        return best;
    }

    std::vector<CurvePiece> pieces_;
    std::vector<std::array<std::size_t, 2>> ends_;  // places' numbers
    std::vector<std::vector<std::size_t>> at_;      // the pieces that end there
    std::vector<bool> taken_;
};

}  // namespace

std::vector<Curve> joined(const std::vector<CurvePiece>& pieces, double near) { return Joiner(pieces, near).curves(); }

}  // namespace normalscope

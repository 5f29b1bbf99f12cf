#pragma once

#include "core/base/beside.h"
#include "core/program/zero_crossing.h"
#include "core/surface/implicit_surface.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace normalscope {

/// f at the corners of a grid of cells, and where on its edges f changes its sign. Throws Stopped when asked to stop.
class SignGrid {
public:
    /// From a corner of the grid along an axis.
    struct Edge {
        glm::ivec3 from;
        glm::length_t axis;
    };

    /// From the box's low corner on, in cells of such sides. Both must outlive this.
    SignGrid(const ImplicitSurface& surface, const formulas::Box& box, const glm::dvec3& step, const Stop& stop);

    const glm::ivec3& counts() const { return counts_; }  ///< cells along each axis
    glm::dvec3 corner(const glm::ivec3& c) const { return low_ + step_ * glm::dvec3(c); }
    /// A number for each corner, and so for the cell whose lowest corner it is.
    std::size_t index(const glm::ivec3& c) const {
        return (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(counts_.y + 1) +
                static_cast<std::size_t>(c.y)) *
                   static_cast<std::size_t>(counts_.x + 1) +
               static_cast<std::size_t>(c.x);
    }
    std::size_t corners() const { return values_.size(); }
    /// NaN where f is not defined.
    double value(const glm::ivec3& c) const { return values_[index(c)]; }
    /// Both are seen: 0 alone says nothing so near to where f may only touch it.
    bool has_both_signs() const;

    bool changes_sign(const Edge& e) const;
    formulas::Edge ends(const Edge& e) const;
    std::vector<Edge> crossed_edges() const;
    /// Where on an edge whose ends have different signs f is 0: from 0 to 1. NaN where it is not, as at a pole.
    double crossing(const Edge& e);
    /// Those that will be asked for, side by side.
    void find_crossings(const std::vector<Edge>& edges);

    template <class F>
    void each_cell(F&& f) const {
        for (glm::ivec3 c(0); c.z < counts_.z; ++c.z)
            for (c.y = 0; c.y < counts_.y; ++c.y)
                for (c.x = 0; c.x < counts_.x; ++c.x) f(c);
    }
    /// The edges of a cell whose ends have different signs, until f says that it is enough.
    template <class F>
    void each_crossed_edge(const glm::ivec3& cell, F&& f) const {
        for (int k = 0; k < 8; ++k)
            for (glm::length_t axis = 0; axis < 3; ++axis) {
                if (k >> axis & 1) continue;
                const Edge edge{cell + glm::ivec3(k & 1, (k >> 1) & 1, k >> 2), axis};
                if (changes_sign(edge) && f(edge)) return;
            }
    }

private:
    template <class F>
    void each_corner(F&& f) const {
        for (glm::ivec3 c(0); c.z <= counts_.z; ++c.z)
            for (c.y = 0; c.y <= counts_.y; ++c.y)
                for (c.x = 0; c.x <= counts_.x; ++c.x) f(c);
    }
    std::size_t key(const Edge& e) const { return 3 * index(e.from) + static_cast<std::size_t>(e.axis); }

    const ImplicitSurface& surface_;
    const Stop& stop_;
    glm::dvec3 low_, step_;
    glm::ivec3 counts_;
    std::vector<double> values_;  // at the corners
    std::unordered_map<std::size_t, double> crossings_;
};

}  // namespace normalscope

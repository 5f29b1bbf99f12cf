#pragma once

#include "core/base/beside.h"
#include "core/mesh/mesh.h"
#include "core/program/evaluate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace normalscope {

/// A mesh's triangles by where they lie in object space, so that what is asked of one place looks at few of them. It fits
/// every M: who asks about the world has the boxes sent there.
class TriangleTree {
public:
    /// Keeps nothing of the mesh. Left unfinished, and useless, where it is asked to stop.
    explicit TriangleTree(const Mesh& mesh, const Stop& stop = {})
        : TriangleTree(mesh.positions, mesh.triangles, stop) {}
    TriangleTree(const std::vector<glm::dvec3>& positions, const std::vector<glm::uvec3>& triangles, const Stop& stop);

    /// Calls `look(triangle)`, in any order, for whichever may be nearer than the nearest so far, which it answers with.
    /// `bound(box)`: how near anything within it could be, not less for a box than for one around it; infinity for nothing.
    template <class Bound, class Look>
    void search(const Bound& bound, const Look& look) const {
        struct Open {
            std::size_t node;
            double least;
        };
        std::array<Open, 64> open;  // two a level
        std::size_t count = 0;
        double nearest = std::numeric_limits<double>::infinity();
        const auto add = [&](std::size_t node, double least) {
            if (least < std::numeric_limits<double>::infinity() && least <= nearest) open[count++] = {node, least};
        };
        if (!nodes_.empty()) add(1, bound(nodes_[1]));
        while (count > 0) {
            const Open here = open[--count];
            if (here.least > nearest) continue;
            if (here.node < leaves_) {
                Open near{2 * here.node, bound(nodes_[2 * here.node])};
                Open far{near.node + 1, bound(nodes_[near.node + 1])};
                if (far.least < near.least) std::swap(near, far);
                add(far.node, far.least);
                add(near.node, near.least);
                continue;
            }
            const std::size_t first = (here.node - leaves_) * kLeaf;
            for (std::size_t i = first; i < std::min(first + kLeaf, order_.size()); ++i) nearest = look(order_[i]);
        }
    }

private:
    static constexpr std::size_t kLeaf = 8;  // triangles

    std::vector<std::uint32_t> order_;  // along a curve that stays near where it is
    std::size_t leaves_ = 0;            // a power of two
    std::vector<formulas::Box>
        nodes_;  // children of node i are 2 i and 2 i + 1; the leaves come last, nothing is node 0
};

/// A mesh's tree, made when it is worth it: not for the few questions of one picture. Any thread may ask.
class TreeInTime {
public:
    /// Asked before each question: the tree or, where every triangle may as well be looked at, null. A large one is made in
    /// the background meanwhile.
    const TriangleTree* for_one(const Mesh& mesh);
    /// Asked before very many: the tree.
    const TriangleTree* for_many(const Mesh& mesh);

private:
    OneAtATime one_at_a_time_;
    std::unique_ptr<const TriangleTree> tree_;
    Beside<std::unique_ptr<const TriangleTree>> coming_;
    int asked_ = 0;
};

}  // namespace normalscope

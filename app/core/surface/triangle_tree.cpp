#include "core/surface/triangle_tree.h"

#include <glm/common.hpp>

#include <bit>
#include <cmath>

namespace normalscope {

namespace {

constexpr formulas::Box kNothing{glm::dvec3(std::numeric_limits<double>::infinity()),
                                 glm::dvec3(-std::numeric_limits<double>::infinity())};

formulas::Box both(const formulas::Box& a, const formulas::Box& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

// Every third bit, from the lowest on, is one of the 21 of v.
std::uint64_t spread(std::uint64_t v) {
    v = (v | v << 32) & 0x001f'0000'0000'ffff;
    v = (v | v << 16) & 0x001f'0000'ff00'00ff;
    v = (v | v << 8) & 0x100f'00f0'0f00'f00f;
    v = (v | v << 4) & 0x10c3'0c30'c30c'30c3;
    return (v | v << 2) & 0x1249'2492'4924'9249;
}

// Where a place comes on the Z-curve through the box: Morton, "A computer oriented geodetic data base", 1966.
std::uint64_t on_curve(const glm::dvec3& p, const formulas::Box& box) {
    constexpr double kCells = 1 << 21;
    std::uint64_t code = 0;
    for (glm::length_t i = 0; i < 3; ++i) {
        const double size = box.high[i] - box.low[i];
        const double cell = size > 0.0 ? kCells * ((p[i] - box.low[i]) / size) : 0.0;
        code |= spread(static_cast<std::uint64_t>(std::clamp(cell, 0.0, kCells - 1.0))) << i;
    }
    return code;
}

}  // namespace

TriangleTree::TriangleTree(const std::vector<glm::dvec3>& positions, const std::vector<glm::uvec3>& triangles,
                           const Stop& stop) {
    struct Placed {
        std::uint64_t code;
        std::uint32_t triangle;
    };
    formulas::Box all = kNothing;
    for (const glm::dvec3& p : positions) all = both(all, {p, p});
    const auto box_of = [&](const glm::uvec3& t) {
        const glm::dvec3 &a = positions[t.x], &b = positions[t.y], &c = positions[t.z];
        return formulas::Box{glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
    };
    std::vector<Placed> placed(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const formulas::Box box = box_of(triangles[i]);
        placed[i] = {on_curve(0.5 * box.low + 0.5 * box.high, all), static_cast<std::uint32_t>(i)};
    }
    if (stop.asked() || triangles.empty()) return;
    std::ranges::sort(placed, {}, [](const Placed& p) { return std::pair(p.code, p.triangle); });
    if (stop.asked()) return;
    leaves_ = std::bit_ceil((triangles.size() + kLeaf - 1) / kLeaf);
    nodes_.assign(2 * leaves_, kNothing);
    order_.reserve(placed.size());
    for (const Placed& p : placed) {
        formulas::Box& leaf = nodes_[leaves_ + order_.size() / kLeaf];
        leaf = both(leaf, box_of(triangles[p.triangle]));
        order_.push_back(p.triangle);
    }
    for (std::size_t i = leaves_ - 1; i > 0; --i) nodes_[i] = both(nodes_[2 * i], nodes_[2 * i + 1]);
}

const TriangleTree* TreeInTime::for_one(const Mesh& mesh) {
    constexpr std::size_t kFew = 64, kMany = 20'000;  // triangles
    constexpr int kWorthIt = 8;                       // questions: a tree costs as much
    if (mesh.triangles.size() <= kFew) return nullptr;
    const TriangleTree* found = nullptr;
    one_at_a_time_.run([&] {
        if (!tree_ && ++asked_ >= kWorthIt) {
            if (coming_) {
                if (coming_.ready()) tree_ = coming_.get();
            } else if (mesh.triangles.size() <= kMany) {
                tree_ = std::make_unique<const TriangleTree>(mesh);
            } else {
                // Of copies, for nobody waits when the mesh goes.
                coming_ = beside([positions = mesh.positions, triangles = mesh.triangles](const Stop& stop) {
                    return std::make_unique<const TriangleTree>(positions, triangles, stop);
                });
            }
        }
        found = tree_.get();
    });
    return found;
}

const TriangleTree* TreeInTime::for_many(const Mesh& mesh) {
    const TriangleTree* found = nullptr;
    one_at_a_time_.run([&] {
        if (!tree_) tree_ = coming_ ? coming_.get() : std::make_unique<const TriangleTree>(mesh);
        found = tree_.get();
    });
    return found;
}

}  // namespace normalscope

// Surface nets (Gibson, "Constrained elastic surface nets", 1998): a vertex in each cell of a grid whose corners differ in
// sign, a quad across each edge whose ends do. Every vertex then goes down the gradient onto the surface itself.

#include "core/mesh/closed_mesh.h"
#include "core/program/points_in_parts.h"
#include "core/program/zero_crossing.h"
#include "core/surface/box_cut.h"
#include "core/surface/implicit_surface.h"
#include "core/surface/newton_steps.h"
#include "core/surface/ray_mesh.h"
#include "core/surface/sign_grid.h"
#include "core/surface/stopped.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

constexpr std::uint32_t kNoVertex = ~std::uint32_t{0};
constexpr int kNewtonSteps = 8;
constexpr int kMoreSteps = 40;
constexpr double kSettled = 0.05;  // of a cell: how near to f = 0 a vertex is after them
constexpr double kThin = 8.0;      // cells, at least, across what is thin

class SurfaceNet {
public:
    SurfaceNet(const ImplicitSurface& surface, const formulas::Box& box, const glm::dvec3& step, const Stop& stop)
        : surface_(surface),
          stop_(stop),
          careful_(formulas::may_jump(surface.program())),
          step_(step),
          largest_step_(std::max({step.x, step.y, step.z})),
          grid_(surface, box, step, stop) {
        add_vertices();
        descend();
        add_quads();
        trim();
    }

    Mesh mesh();
    bool has_both_signs() const { return grid_.has_both_signs(); }

private:
    using Edge = SignGrid::Edge;
    /// work(begin, end) for all of so many vertices, for each of which f is computed several times.
    template <class Work>
    void in_threads(std::size_t vertices, const Work& work) const {
        constexpr std::size_t kTimes = 10;
        formulas::points_in_parts(surface_.program(), vertices, 1, work, kTimes);
    }

    void add_vertices();
    void settle(std::size_t vertex, const glm::dvec3& start, formulas::Sample& sample);
    void anchor(std::size_t vertex, formulas::Sample& sample);
    void descend();
    void add_quads();
    void add_quad(const std::array<std::uint32_t, 4>& q);
    void trim();

    const ImplicitSurface& surface_;
    const Stop& stop_;
    bool careful_;  // a change of sign may be a pole or a jump
    glm::dvec3 step_;
    double largest_step_;
    SignGrid grid_;
    std::vector<glm::ivec3> cells_;        // of the vertices
    std::vector<std::uint32_t> vertices_;  // of the cell whose lowest corner it is
    std::vector<glm::dvec3> positions_, gradients_;
    std::vector<double> sizes_;  // of f around each vertex
    std::vector<char> lost_;     // 1: no zero was found there after all
    std::vector<glm::uvec3> triangles_;
};

void SurfaceNet::add_vertices() {
    if (careful_) grid_.find_crossings(grid_.crossed_edges());
    vertices_.assign(grid_.corners(), kNoVertex);
    grid_.each_cell([&](const glm::ivec3& c) {
        std::array<double, 8> f{};
        int negative = 0;
        double size = 0.0;
        for (int k = 0; k < 8; ++k) {
            f[static_cast<std::size_t>(k)] = grid_.value(c + glm::ivec3(k & 1, (k >> 1) & 1, k >> 2));
            if (std::isnan(f[static_cast<std::size_t>(k)])) return;
            negative += f[static_cast<std::size_t>(k)] < 0.0;
            size = std::max(size, std::abs(f[static_cast<std::size_t>(k)]));
        }
        if (negative == 0 || negative == 8) return;
        // In the middle of where the cell's edges meet the surface.
        glm::dvec3 sum(0.0);
        int crossings = 0;
        for (unsigned k = 0; k < 8; ++k)
            for (unsigned axis = 0; axis < 3; ++axis) {
                const unsigned l = k | (1u << axis);
                if (l == k || (f[k] < 0.0) == (f[l] < 0.0)) continue;
                const auto along = static_cast<glm::length_t>(axis);
                glm::dvec3 at(k & 1, (k >> 1) & 1, k >> 2);
                at[along] = careful_ ? grid_.crossing({c + glm::ivec3(at), along}) : f[k] / (f[k] - f[l]);
                if (std::isnan(at[along])) continue;
                sum += at;
                ++crossings;
            }
        if (crossings == 0) return;
        vertices_[grid_.index(c)] = static_cast<std::uint32_t>(positions_.size());
        positions_.push_back(grid_.corner(c) + step_ / static_cast<double>(crossings) * sum);
        cells_.push_back(c);
        sizes_.push_back(size);
    });
}

void SurfaceNet::descend() {
    const std::vector<glm::dvec3> start = positions_;
    // What would leave its cell is near a double point or a pole.
    std::vector<formulas::Sample> samples =
        newton_steps(surface_.program(), positions_, kNewtonSteps, 1.2 * largest_step_);
    if (!surface_.degree())
        in_threads(positions_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) settle(v, start[v], samples[v]);
        });
    lost_.resize(positions_.size());
    std::vector<std::size_t> astray;
    std::vector<Edge> edges;
    const double near = (careful_ ? 1e-6 : kSettled) * largest_step_;
    for (std::size_t v = 0; v < positions_.size(); ++v) {
        const double off = std::abs(samples[v].value);
        if (off <= 0.3 * sizes_[v] && off <= near * glm::length(samples[v].gradient)) continue;
        astray.push_back(v);
        grid_.each_crossed_edge(cells_[v], [&](const Edge& edge) {
            edges.push_back(edge);
            return true;
        });
    }
    grid_.find_crossings(edges);
    for (const std::size_t v : astray) anchor(v, samples[v]);
    for (const formulas::Sample& sample : samples) gradients_.push_back(sample.gradient);
}

// Further steps for vertices that need them, as where f is an exponential that falls steeply.
void SurfaceNet::settle(std::size_t vertex, const glm::dvec3& start, formulas::Sample& sample) {
    go_on_unless(stop_);
    for (int i = 0; i < kMoreSteps; ++i) {
        const glm::dvec3& g = sample.gradient;
        if (!(std::abs(sample.value) > 1e-9 * largest_step_ * glm::length(g))) return;
        const glm::dvec3 next = positions_[vertex] - sample.value / glm::dot(g, g) * g;
        if (!(glm::length(next - start) <= 1.2 * largest_step_)) return;
        positions_[vertex] = next;
        sample = surface_.at({next});
    }
}

// Where Newton's steps go astray, as where f is steep on one side and flat on the other: to a zero on one of the cell's edges.
void SurfaceNet::anchor(std::size_t vertex, formulas::Sample& sample) {
    lost_[vertex] = 1;
    grid_.each_crossed_edge(cells_[vertex], [&](const Edge& edge) {
        const double at = grid_.crossing(edge);
        if (std::isnan(at)) return false;
        const auto [a, b] = grid_.ends(edge);
        positions_[vertex] = glm::mix(a, b, at);
        sample = surface_.at({positions_[vertex]});
        lost_[vertex] = 0;
        return true;
    });
}

void SurfaceNet::add_quad(const std::array<std::uint32_t, 4>& q) {
    for (const std::uint32_t v : q)
        if (v == kNoVertex || lost_[v]) return;
    const auto distance = [&](std::size_t a, std::size_t b) {
        return glm::distance(positions_[q[a]], positions_[q[b]]);
    };
    if (distance(0, 2) <= distance(1, 3)) {
        triangles_.push_back({q[0], q[1], q[2]});
        triangles_.push_back({q[0], q[2], q[3]});
    } else {
        triangles_.push_back({q[0], q[1], q[3]});
        triangles_.push_back({q[1], q[2], q[3]});
    }
}

void SurfaceNet::add_quads() {
    const glm::ivec3 counts = grid_.counts();
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        glm::ivec3 along(0), u(0), v(0);
        along[axis] = 1;
        u[(axis + 1) % 3] = 1;
        v[(axis + 2) % 3] = 1;
        for (glm::ivec3 c(0); c.z <= counts.z; ++c.z)
            for (c.y = 0; c.y <= counts.y; ++c.y)
                for (c.x = 0; c.x <= counts.x; ++c.x) {
                    // The four cells around the edge from here along the axis.
                    if (c[axis] == counts[axis] || c[(axis + 1) % 3] == 0 || c[(axis + 2) % 3] == 0) continue;
                    if (c[(axis + 1) % 3] == counts[(axis + 1) % 3] || c[(axis + 2) % 3] == counts[(axis + 2) % 3])
                        continue;
                    const double here = grid_.value(c), there = grid_.value(c + along);
                    if ((here < 0.0) == (there < 0.0) || std::isnan(here) || std::isnan(there)) continue;
                    if (careful_ && std::isnan(grid_.crossing({c, axis}))) continue;
                    const auto cell = [&](const glm::ivec3& at) { return vertices_[grid_.index(at)]; };
                    std::array quad{cell(c - u - v), cell(c - v), cell(c), cell(c - u)};
                    if (there < 0.0) std::swap(quad[1], quad[3]);  // counterclockwise as seen from where f > 0
                    add_quad(quad);
                }
    }
}

// Leaves out what lies beyond the clip, and ends the last triangles at its edge: at a cube's faces they are cut, at the
// ball their vertices are moved.
void SurfaceNet::trim() {
    if (surface_.source().clip == Clip::Box) {
        const std::size_t before = positions_.size();
        cut_to_box(surface_, positions_, triangles_);
        for (std::size_t v = before; v < positions_.size(); ++v)
            gradients_.push_back(surface_.at({positions_[v]}).gradient);
        lost_.resize(positions_.size());
        return;
    }
    std::vector<bool> inside(positions_.size());
    for (std::size_t v = 0; v < positions_.size(); ++v) inside[v] = surface_.inside_clip(positions_[v]);
    std::erase_if(triangles_, [&](const glm::uvec3& t) { return !inside[t.x] && !inside[t.y] && !inside[t.z]; });
    std::vector<bool> outside(positions_.size(), false);
    for (const glm::uvec3& t : triangles_)
        for (int k = 0; k < 3; ++k) outside[t[k]] = !inside[t[k]];
    std::vector<std::uint32_t> moved;
    for (std::uint32_t v = 0; v < positions_.size(); ++v)
        if (outside[v]) moved.push_back(v);
    in_threads(moved.size(), [&](std::size_t begin, std::size_t end) {
        for (const std::uint32_t v : std::span(moved).subspan(begin, end - begin)) {
            positions_[v] =
                onto_ball(surface_.program(), surface_.ball(), positions_[v], kNewtonSteps, 4.0 * largest_step_);
            const formulas::Sample s = surface_.at({positions_[v]});
            gradients_[v] = s.gradient;
            lost_[v] = careful_ && !(std::abs(s.value) <= 1e-6 * largest_step_ * glm::length(s.gradient)) ? 1 : 0;
        }
    });
    std::erase_if(triangles_, [&](const glm::uvec3& t) { return lost_[t.x] || lost_[t.y] || lost_[t.z]; });
}

Mesh SurfaceNet::mesh() {
    Mesh mesh;
    std::vector<std::uint32_t> used(positions_.size(), kNoVertex);
    for (const glm::uvec3& t : triangles_)
        for (int k = 0; k < 3; ++k) used[t[k]] = 0;
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < used.size(); ++v)
        if (used[v] == 0) order.push_back(v);
    // In steps of the golden section through the grid, so that the first few vertices are spread over all of it.
    const std::size_t count = order.size();
    auto stride = static_cast<std::size_t>(0.6180339887 * static_cast<double>(count)) | 1u;
    while (std::gcd(stride, count) > 1) ++stride;
    for (std::size_t i = 0, at = 0; i < count; ++i, at = (at + stride) % count) {
        const std::uint32_t v = order[at];
        used[v] = static_cast<std::uint32_t>(i);
        mesh.positions.push_back(positions_[v]);
        const double length = glm::length(gradients_[v]);
        mesh.normals.push_back(length > 0.0 && std::isfinite(length) ? gradients_[v] / length : glm::dvec3(0.0));
    }
    for (const glm::uvec3& t : triangles_) mesh.triangles.push_back({used[t.x], used[t.y], used[t.z]});
    mesh.closed = edges_cancel(mesh.triangles);
    return mesh;
}

}  // namespace

Mesh polygonised(const ImplicitSurface& surface, int cells, const Stop& stop) {
    if (!surface.region()) return {};
    // A margin, so that no edge of the region's surface lacks a cell beside it.
    const auto within = [](formulas::Box box, double margin) {
        return formulas::Box{box.low - margin, box.high + margin};
    };
    const auto largest = [](const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); };
    const formulas::Box box = within(*surface.region(), 1e-3 * surface.source().bound);
    const double cell = largest(box.high - box.low) / cells;
    // What a cube cuts off must reach beyond it first.
    const double beyond = surface.source().clip == Clip::Box ? 1.5 * cell : 0.0;
    Mesh mesh = SurfaceNet(surface, within(box, beyond), glm::dvec3(cell), stop).mesh();
    if (!mesh.triangles.empty()) return mesh;

    // Smaller than the cells, or thinner.
    const auto close = surface.close_region();
    if (!close) return {};
    const formulas::Box around = within(*close, 1e-3 * largest(close->high - close->low));
    const glm::dvec3 size = around.high - around.low, step(largest(size) / cells);
    SurfaceNet net(surface, around, glm::min(step, size / kThin), stop);
    if (net.has_both_signs()) mesh = net.mesh();
    return mesh.triangles.empty() ? ray_mesh(surface, around, cells, stop) : mesh;
}

}  // namespace normalscope

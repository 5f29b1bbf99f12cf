#include "core/mesh/closed_mesh.h"

#include "core/base/beside.h"
#include "core/base/disjoint_sets.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

namespace normalscope {

namespace {

// Steele, Lea & Flood, "Fast splittable pseudorandom number generators", 2014: every bit of the result hangs on every bit.
std::uint64_t scattered(std::uint64_t x) {
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
    x = (x ^ x >> 27) * 0x94D049BB133111EBu;
    return x ^ x >> 31;
}

}  // namespace

// Adds up a random number for each edge and takes off the one for its way back: what is left is 0 if all of them have
// one, and else 0 only once in 2⁶⁴ cases. That needs no table of edges.
bool edges_cancel(const std::vector<glm::uvec3>& triangles) {
    std::uint64_t sum = 0;
    for (const glm::uvec3& t : triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint64_t a = t[k], b = t[(k + 1) % 3];
            const std::uint64_t edge = scattered(std::min(a, b) << 32 | std::max(a, b));
            sum += a < b ? edge : 0 - edge;
        }
    return sum == 0;
}

bool is_closed(const Mesh& mesh) {
    if (mesh.triangles.empty()) return false;
    Beside<bool> has_no_rim = beside([&] { return edges_cancel(mesh.triangles); });
    DisjointSets parts(mesh.positions.size());
    for (const glm::uvec3& t : mesh.triangles) {
        parts.join(t.x, t.y);
        parts.join(t.x, t.z);
    }
    std::vector<double> volumes(mesh.positions.size(), 0.0);  // six times, by the divergence theorem
    for (const glm::uvec3& t : mesh.triangles)
        volumes[parts.of(t.x)] += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z]));
    return std::ranges::all_of(mesh.triangles, [&](const glm::uvec3& t) { return volumes[parts.of(t.x)] > 0.0; }) &&
           has_no_rim.get();
}

}  // namespace normalscope

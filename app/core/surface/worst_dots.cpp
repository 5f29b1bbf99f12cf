#include "core/surface/worst_dots.h"

#include "core/base/beside.h"
#include "core/surface/probe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// The compiler makes the blocks' loops thrice, for processors with AVX-512, with AVX2 and without, and the one that fits is taken as
// the program starts.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__)
#define NORMALSCOPE_WIDE_LOOPS __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define NORMALSCOPE_WIDE_LOOPS
#endif

namespace normalscope {

namespace {

constexpr std::size_t kBlock = 64;
constexpr std::size_t kNormalsWorthAThread = 100'000;

using Lane = std::array<double, kBlock>;
struct Lanes {
    Lane x, y, z;
};

// A vector sent to `matrix` · v + `plus`.
struct Affine {
    glm::dmat3 matrix{0.0};
    glm::dvec3 plus{0.0};
};

// Only directions count: the squares of 1e200 would be infinite.
double scale(const glm::dmat3& m, const glm::dvec3& plus = {}) {
    double largest = 0.0;
    for (const glm::dvec3& v : {m[0], m[1], m[2], plus})
        largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest > 0.0 ? 1.0 / largest : 1.0;
}
Affine affine(const NormalMap& map) {
    const glm::dmat3 matrix(map.matrix);
    const glm::dvec3 plus = map.w * glm::dvec3(map.matrix[3]);
    const double by = scale(matrix, plus);
    return {by * matrix, by * plus};
}

struct Task {
    std::array<Affine, 3> rules;
    glm::dmat3 tangents;
};

// For each place in the block, the square of the largest cosine so far: as a fraction, since a division costs more than
// all else that is done for a normal.
struct Worst {
    Lane above, below;
};
using WorstByRule = std::array<Worst, 3>;

NORMALSCOPE_WIDE_LOOPS void look_at_block(const glm::dvec3* block, const Task& task, WorstByRule& worst) {
    Lanes n, t1, t2;
    Lane l1, l2;
    for (std::size_t i = 0; i < kBlock; ++i) {
        n.x[i] = block[i].x;
        n.y[i] = block[i].y;
        n.z[i] = block[i].z;
    }
    const glm::dmat3 m = task.tangents;
    for (std::size_t i = 0; i < kBlock; ++i) {
        // Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
        const double x = n.x[i], y = n.y[i], z = n.z[i];
        const double sign = std::copysign(1.0, z), a = -1.0 / (sign + z), b = x * y * a;
        const double ux = 1.0 + sign * x * x * a, uy = sign * b, uz = -sign * x;
        const double vx = b, vy = sign + y * y * a, vz = -y;
        t1.x[i] = m[0][0] * ux + m[1][0] * uy + m[2][0] * uz;
        t1.y[i] = m[0][1] * ux + m[1][1] * uy + m[2][1] * uz;
        t1.z[i] = m[0][2] * ux + m[1][2] * uy + m[2][2] * uz;
        t2.x[i] = m[0][0] * vx + m[1][0] * vy + m[2][0] * vz;
        t2.y[i] = m[0][1] * vx + m[1][1] * vy + m[2][1] * vz;
        t2.z[i] = m[0][2] * vx + m[1][2] * vy + m[2][2] * vz;
        const double there = x * x + y * y + z * z;  // 1, or 0 where there is no normal
        l1[i] = (t1.x[i] * t1.x[i] + t1.y[i] * t1.y[i] + t1.z[i] * t1.z[i]) * there;
        l2[i] = (t2.x[i] * t2.x[i] + t2.y[i] * t2.y[i] + t2.z[i] * t2.z[i]) * there;
    }
    for (std::size_t k = 0; k < task.rules.size(); ++k) {
        const auto [r, plus] = task.rules[k];  // which no write below could change
        auto& [above, below] = worst[k];
        for (std::size_t i = 0; i < kBlock; ++i) {
            const double x = n.x[i], y = n.y[i], z = n.z[i];
            const double nx = r[0][0] * x + r[1][0] * y + r[2][0] * z + plus.x;
            const double ny = r[0][1] * x + r[1][1] * y + r[2][1] * z + plus.y;
            const double nz = r[0][2] * x + r[1][2] * y + r[2][2] * z + plus.z;
            const double d1 = nx * t1.x[i] + ny * t1.y[i] + nz * t1.z[i];
            const double d2 = nx * t2.x[i] + ny * t2.y[i] + nz * t2.z[i];
            // d² / (l · |N|²), the larger of the two; a tangent of no length has no part in it.
            const double a = d1 * d1 * l2[i], b = d2 * d2 * l1[i];
            const double square = (a > b ? a : b), whole = (nx * nx + ny * ny + nz * nz) * l1[i] * l2[i];
            const bool worse = square * below[i] > above[i] * whole;
            above[i] = worse ? square : above[i];
            below[i] = worse ? whole : below[i];
        }
    }
}

void look_at(std::span<const glm::dvec3> normals, const Task& task, WorstByRule& worst) {
    std::array<glm::dvec3, kBlock> rest;
    for (std::size_t first = 0; first < normals.size(); first += kBlock) {
        const glm::dvec3* block = &normals[first];
        if (const std::size_t count = normals.size() - first; count < kBlock) {
            rest.fill(normals.back());  // the last one again changes nothing
            std::copy_n(block, count, rest.begin());
            block = rest.data();
        }
        look_at_block(block, task, worst);
    }
}

}  // namespace

ByRule<std::optional<double>> worst_dots(std::span<const glm::dvec3> normals,
                                         const ByRule<std::optional<NormalMap>>& maps, const glm::dmat3& tangents) {
    Task task{.rules = {}, .tangents = scale(tangents) * tangents};
    for (std::size_t k = 0; k < maps.size(); ++k)
        if (maps[k]) task.rules[k] = affine(*maps[k]);
    const std::size_t threads = threads_for(normals.size(), kNormalsWorthAThread);
    WorstByRule none;
    for (Worst& one : none) {
        one.above.fill(-1.0);  // less than any square: no normal has counted yet
        one.below.fill(1.0);
    }
    std::vector<WorstByRule> worst(threads, none);
    in_parts(threads, normals.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
        look_at(normals.subspan(begin, end - begin), task, worst[part]);
    });
    ByRule<std::optional<double>> result;
    for (std::size_t k = 0; k < maps.size(); ++k) {
        if (!maps[k]) continue;
        double most = -1.0;
        for (const WorstByRule& one : worst)
            for (std::size_t i = 0; i < kBlock; ++i) most = std::max(most, one[k].above[i] / one[k].below[i]);
        if (most >= 0.0) result[k] = std::min(std::sqrt(most), 1.0);
    }
    return result;
}

ByRule<std::optional<double>> worst_dots(const Mesh& mesh, const ByRule<std::optional<NormalMap>>& maps,
                                         const Transform<World, Object>& world_from_object) {
    if (world_from_object.affine())
        return worst_dots(mesh.normals, maps, world_from_object.normal_matrices_by_rule().naive);
    ByRule<std::optional<double>> result;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Point<Object> p{mesh.positions[i]};
        const Normal<Object> n{mesh.normals[i]};
        if (n.xyz == glm::dvec3(0.0) || !world_from_object.reaches(p)) continue;
        const std::array<Vector<Object>, 2> tangents = probe_with(p, n).tangents;
        for (std::size_t k = 0; k < maps.size(); ++k)
            for (const Vector<Object>& t : tangents) {
                if (!maps[k]) continue;
                const glm::dvec3 sent = (*maps[k])(n).xyz, along = world_from_object(p, t).xyz;
                const double lengths = glm::length(sent) * glm::length(along);
                if (lengths > 0.0)
                    result[k] = std::max(result[k].value_or(0.0), std::abs(glm::dot(sent, along)) / lengths);
            }
    }
    return result;
}

}  // namespace normalscope

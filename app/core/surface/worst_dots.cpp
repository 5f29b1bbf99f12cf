#include "core/surface/worst_dots.h"

#include "core/base/beside.h"
#include "core/surface/probe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

constexpr std::size_t kNormalsWorthAThread = 100'000;
constexpr std::size_t kAhead = 128;  // normals that are fetched from memory meanwhile

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

// The squares of the largest cosines; less than 0 where no normal has counted.
using Squares = std::array<double, 3>;

// Vectors of the processor, as GCC and Clang have them.
using Lanes2 = double __attribute__((vector_size(16)));
using Lanes4 = double __attribute__((vector_size(32)));
using Lanes8 = double __attribute__((vector_size(64)));

// x, y or z of as many normals as a vector has lanes.
template <std::size_t kAxis, class Lane, std::size_t... kLane>
[[gnu::always_inline]] inline void take(const glm::dvec3* normals, Lane& axis, std::index_sequence<kLane...>) {
    constexpr std::size_t kWidth = sizeof...(kLane);
    static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
    const double* numbers = &normals->x;  // x y z x y z …
    Lane first, second, third;
    std::memcpy(&first, numbers, sizeof first);
    std::memcpy(&second, numbers + kWidth, sizeof second);
    std::memcpy(&third, numbers + 2 * kWidth, sizeof third);
    const Lane of_two =
        __builtin_shufflevector(first, second, (3 * kLane + kAxis < 2 * kWidth ? 3 * kLane + kAxis : 0)...);
    axis = __builtin_shufflevector(of_two, third,
                                   (3 * kLane + kAxis < 2 * kWidth ? kLane : 3 * kLane + kAxis - kWidth)...);
}

// As many normals side by side as a vector has lanes, and nothing in memory but them.
template <class Lane>
[[gnu::always_inline]] inline Squares look_at(std::span<const glm::dvec3> normals, const Task& task) {
    constexpr std::size_t kWidth = sizeof(Lane) / sizeof(double);
    const Lane one = Lane{} + 1.0;
    const glm::dmat3 m = task.tangents;
    // As fractions, since a division costs more than all else that is done for a normal.
    struct Fraction {
        Lane above, below;
    };
    std::array<Fraction, 3> worst;
    worst.fill({-one, one});
    std::array<glm::dvec3, kWidth> rest;
    for (std::size_t begin = 0; begin < normals.size(); begin += kWidth) {
        const glm::dvec3* block = &normals[begin];
        if (const std::size_t count = normals.size() - begin; count < kWidth) {
            rest.fill(normals.back());  // the last one again changes nothing
            std::copy_n(block, count, rest.begin());
            block = rest.data();
        }
        const glm::dvec3* later = &normals[std::min(begin + kAhead, normals.size() - 1)];
        for (std::size_t i = 0; i < sizeof rest; i += 64) __builtin_prefetch(reinterpret_cast<const char*>(later) + i);
        constexpr std::make_index_sequence<kWidth> lanes;
        Lane x, y, z;
        take<0>(block, x, lanes);
        take<1>(block, y, lanes);
        take<2>(block, z, lanes);
        // The basis of Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017, but for one's sign: with
        // s, the sign of z, and c = 1 / (1 + |z|) it is (1 - x² c, -x y c, -s x) and (-x y c, 1 - y² c, -s y). M sends it to
        // m0 - x g and m1 - y g, where g = c (x m0 + y m1) + s m2: half the multiplications of sending both.
        const auto from_below = z < 0.0;
        const Lane c = 1.0 / (1.0 + (from_below ? -z : z)), cx = c * x, cy = c * y;
        const Lane s = from_below ? -one : one;
        const Lane gx = cx * m[0][0] + cy * m[1][0] + s * m[2][0];
        const Lane gy = cx * m[0][1] + cy * m[1][1] + s * m[2][1];
        const Lane gz = cx * m[0][2] + cy * m[1][2] + s * m[2][2];
        const Lane t1x = m[0][0] - x * gx, t1y = m[0][1] - x * gy, t1z = m[0][2] - x * gz;
        const Lane t2x = m[1][0] - y * gx, t2y = m[1][1] - y * gy, t2z = m[1][2] - y * gz;
        const Lane there = x * x + y * y + z * z;
        const Lane l1 = (t1x * t1x + t1y * t1y + t1z * t1z) * there;
        const Lane l2 = (t2x * t2x + t2y * t2y + t2z * t2z) * there;
        const Lane l12 = l1 * l2;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [r, plus] = task.rules[k];
            auto& [above, below] = worst[k];
            const Lane nx = r[0][0] * x + r[1][0] * y + r[2][0] * z + plus.x;
            const Lane ny = r[0][1] * x + r[1][1] * y + r[2][1] * z + plus.y;
            const Lane nz = r[0][2] * x + r[1][2] * y + r[2][2] * z + plus.z;
            const Lane d1 = nx * t1x + ny * t1y + nz * t1z;
            const Lane d2 = nx * t2x + ny * t2y + nz * t2z;
            // d² / (l · |N|²), the larger of the two; a tangent of no length has no part in it.
            const Lane a = d1 * d1 * l2, b = d2 * d2 * l1;
            const Lane square = (a > b ? a : b), whole = (nx * nx + ny * ny + nz * nz) * l12;
            const auto worse = square * below > above * whole;
            above = worse ? square : above;
            below = worse ? whole : below;
        }
    }
    Squares squares;
    for (std::size_t k = 0; k < squares.size(); ++k) {
        const Lane fractions = worst[k].above / worst[k].below;
        squares[k] = fractions[0];
        for (std::size_t i = 1; i < kWidth; ++i) squares[k] = std::max(squares[k], fractions[i]);
    }
    return squares;
}

using Look = Squares(std::span<const glm::dvec3>, const Task&);
Squares look_at_2(std::span<const glm::dvec3> normals, const Task& task) { return look_at<Lanes2>(normals, task); }
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__)
[[gnu::target("arch=x86-64-v3")]] Squares look_at_4(std::span<const glm::dvec3> normals, const Task& task) {
    return look_at<Lanes4>(normals, task);
}
[[gnu::target("arch=x86-64-v4")]] Squares look_at_8(std::span<const glm::dvec3> normals, const Task& task) {
    return look_at<Lanes8>(normals, task);
}
Look* fastest() {
    if (__builtin_cpu_supports("x86-64-v4")) return look_at_8;
    return __builtin_cpu_supports("x86-64-v3") ? look_at_4 : look_at_2;
}
#else
Look* fastest() { return look_at_2; }
#endif

}  // namespace

ByRule<std::optional<double>> worst_dots(std::span<const glm::dvec3> normals,
                                         const ByRule<std::optional<NormalMap>>& maps, const glm::dmat3& tangents) {
    Task task{.rules = {}, .tangents = scale(tangents) * tangents};
    for (std::size_t k = 0; k < maps.size(); ++k)
        if (maps[k]) task.rules[k] = affine(*maps[k]);
    const std::size_t threads = threads_for(normals.size(), kNormalsWorthAThread);
    std::vector<Squares> squares(threads);
    in_parts(threads, normals.size(), [&, look = fastest()](std::size_t part, std::size_t begin, std::size_t end) {
        squares[part] = look(normals.subspan(begin, end - begin), task);
    });
    ByRule<std::optional<double>> result;
    for (std::size_t k = 0; k < maps.size(); ++k) {
        if (!maps[k]) continue;
        double most = -1.0;
        for (const Squares& one : squares) most = std::max(most, one[k]);
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

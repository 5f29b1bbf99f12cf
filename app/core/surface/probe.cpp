#include "core/surface/probe.h"

#include "core/scene/mistakes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

Probe probe_with(Point<Object> point, Normal<Object> normal) {
    const glm::dvec3 n = glm::normalize(normal.xyz);
    // The tangent that is level where there is one: it is easier to read than an arbitrary one.
    const glm::dvec3 level = glm::cross(glm::dvec3(0.0, 1.0, 0.0), n);
    const glm::dvec3 t0 =
        glm::length(level) > 1e-6 ? glm::normalize(level) : glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), n));
    return {point, {n}, {Vector<Object>{t0}, Vector<Object>{glm::cross(n, t0)}}};
}

namespace {

// What a matrix that stretches by `most` leaves of a vector that it should send to zero is but rounding.
Normal<World> without_rounding(Normal<World> n, double most) {
    constexpr double kRoundings = 32.0 * std::numeric_limits<double>::epsilon();
    const double largest = std::max({std::abs(n.xyz.x), std::abs(n.xyz.y), std::abs(n.xyz.z)});  // no square underflows
    return largest <= kRoundings * most ? Normal<World>{} : n;
}

}  // namespace

ProbeInWorld in_world(const Probe& probe, const Transform<World, Object>& world_from_object) {
    return in_world(probe, world_from_object, Scene{});
}

ProbeInWorld in_world(const Probe& probe, const Transform<World, Object>& world_from_object, const Scene& scene,
                      double right_power) {
    ProbeInWorld result;
    result.object = probe;
    result.point = world_from_object(probe.point);
    result.affine = world_from_object.affine();
    const std::optional<glm::dmat3> mistaken = mistaken_tangents(scene, world_from_object);
    for (std::size_t k = 0; k < 2; ++k) {
        const Vector<Object> t = probe.tangents[k];
        result.tangents[k] = mistaken ? Vector<World>{*mistaken * t.xyz} : world_from_object(probe.point, t);
    }
    const double largest_stretch = world_from_object.at(probe.point).normal_matrices_by_rule().sigma.x;
    for (std::size_t r = 0; r < kRules.size() && probe.has_normal(); ++r) {
        std::optional<Normal<World>> n = transform_normal(world_from_object, probe.normal, kRules[r]);
        const bool bent = kRules[r] == Rule::InverseTranspose && right_power != -1.0;
        if (bent || (kRules[r] == Rule::Naive && !plainly_naive(scene))) {
            const std::optional<NormalMap> map = normal_map(scene, world_from_object, kRules[r], right_power);
            n = map ? std::optional((*map)(probe.normal)) : std::nullopt;
        }
        if (n && kRules[r] == Rule::Naive) n = without_rounding(*n, largest_stretch);
        if (n && kRules[r] == Rule::Cofactor) n = without_rounding(*n, largest_stretch * largest_stretch);
        // 0/|0| is not a number.
        const bool divided = kRules[r] == Rule::Naive && scene.mistake == Mistake::ZeroNormal;
        if (n && divided && n->xyz == glm::dvec3(0.0)) n.reset();
        result.normals[r] = n;
        if (n) result.dots[r] = std::array{dot(*n, result.tangents[0]), dot(*n, result.tangents[1])};
    }
    for (const Point<Object>& corner : probe.polygon)
        if (world_from_object.reaches(corner)) result.polygon.push_back(world_from_object(corner));
    if (result.polygon.size() < probe.polygon.size()) result.polygon.clear();
    if (!probe.has_normal()) return result;
    const auto by_inverse = world_from_object(probe.point, probe.normal);
    const Normal<World> by_cofactor = transform_normal_by_cofactor(world_from_object.at(probe.point), probe.normal);
    if (by_inverse || glm::length(by_cofactor.xyz) > 0.0) result.truth = by_inverse.value_or(by_cofactor);
    if (by_inverse && result.normals[0]) result.error_degrees = angle_degrees(result.normals[0]->xyz, by_inverse->xyz);
    return result;
}

}  // namespace normalscope

#pragma once

#include "core/picture/frame.h"

#include <span>
#include <vector>

namespace normalscope {

// Small things made of triangles anew every frame, appended to a list: the probe's arrows and marks, the axes.

using Solids = std::vector<SolidVertex>;

/// Shaft and cone of an arrow, in proportion to its radius; the head takes at most half of a short one.
struct ArrowProportions {
    static constexpr float kHeadRadius = 2.6f;
    static constexpr float kHeadLength = 6.5f;
    static constexpr float kLongestHead = 0.5f;
    static constexpr float kOfObject = 0.65f;     ///< normals in object space are thinner: a shape of their own
    static constexpr float kToSecondHead = 0.9f;  ///< in heads, from tip to tip
};

/// An arrow from `base` along `vector`; nothing where the vector is zero.
void add_arrow(Solids& solids, const glm::dvec3& base, const glm::dvec3& vector, double radius, const glm::vec4& color);
/// A round line through the points.
void add_tube(Solids& solids, std::span<const glm::dvec3> points, double radius, const glm::vec4& color,
              bool closed = false);
/// A cube, `axis` of which lies along `direction`.
void add_cube(Solids& solids, const glm::dvec3& centre, const glm::dvec3& direction, double half,
              const glm::vec4& color);
void add_ball(Solids& solids, const glm::dvec3& centre, double radius, const glm::vec4& color);
/// A flat, unlit parallelogram about `centre`, seen from both sides.
void add_patch(Solids& solids, const glm::dvec3& centre, const glm::dvec3& half_u, const glm::dvec3& half_v,
               const glm::vec4& color);

}  // namespace normalscope

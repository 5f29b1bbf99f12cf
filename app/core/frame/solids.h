#pragma once

#include "core/frame/frame.h"

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
    static constexpr float kAround = 1.2f;        ///< dashes around an arrow that lies in the same place
    static constexpr float kOfObject = 0.65f;     ///< normals in object space are thinner: a shape of their own
    static constexpr float kToSecondHead = 0.9f;  ///< in heads, from tip to tip
    static constexpr int kDashes = 3;             ///< with gaps as long as they are
    static constexpr float kDashedWidth = 0.94f;  ///< of another's, which hides it where both lie in one place
    static constexpr float kHollow = 0.62f;       ///< of a hollow head, seen from the side
};

/// An arrow from `base` along `vector`; nothing where the vector is zero.
void add_arrow(Solids& solids, const glm::dvec3& base, const glm::dvec3& vector, double radius, const glm::vec4& color);
/// The same in the shape of its kind; a hollow head is `paper` within.
void add_arrow(Solids& solids, const glm::dvec3& base, const glm::dvec3& vector, double radius, const glm::vec4& color,
               ArrowLook look, const glm::vec3& paper);
/// A round line through the points.
void add_tube(Solids& solids, std::span<const glm::dvec3> points, double radius, const glm::vec4& color,
              bool closed = false);
/// So many points around `centre`, in the plane perpendicular to `axis`, a unit vector.
std::vector<glm::dvec3> circle(const glm::dvec3& centre, const glm::dvec3& axis, double radius, int points);
/// A cube, `axis` of which lies along `direction`.
void add_cube(Solids& solids, const glm::dvec3& centre, const glm::dvec3& direction, double half,
              const glm::vec4& color);
void add_ball(Solids& solids, const glm::dvec3& centre, double radius, const glm::vec4& color);
/// A flat, unlit, convex polygon, seen from both sides.
void add_polygon(Solids& solids, std::span<const glm::dvec3> corners, const glm::vec4& color);
/// A flat, unlit parallelogram about `centre`, seen from both sides.
void add_patch(Solids& solids, const glm::dvec3& centre, const glm::dvec3& half_u, const glm::dvec3& half_v,
               const glm::vec4& color);

/// No word lies on the lines from point to point.
void keep_clear(Pane& pane, std::span<const glm::dvec3> path, double half_width = 0.0);

}  // namespace normalscope

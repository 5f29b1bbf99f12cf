#pragma once

#include "core/math/camera.h"
#include "core/math/transform.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace normalscope {

/// Where M takes the plane z = 0 of object space, and how it is seen straight on. Even an M that is not affine takes a plane to
/// a plane. What stands in that plane and is perpendicular to the image of a curve is so in the picture; and of the right
/// normal the part within the plane always is, as (M3⁻¹)ᵀn · M3 v = n · v for every v in z = 0.
struct FlatPlane {
    /// What M leaves of it. Of a line, the plane is that through it which faces z most.
    enum class Image { Plane, Line, Point } image = Image::Plane;
    Point<World> origin;                                                        ///< a point of the plane
    glm::dvec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, normal{0.0, 0.0, 1.0};  ///< unit; the normal toward the eye
    bool tilted = false;                                                        ///< no longer parallel to z = 0

    /// In the plane, right and up, as seen from straight ahead: a place by its distances from the world's axes, a direction
    /// by its part within the plane.
    glm::dvec2 place(Point<World> p) const { return part(p.xyz); }
    glm::dvec2 part(const glm::dvec3& direction) const { return {glm::dot(right, direction), glm::dot(up, direction)}; }
    Point<World> at(glm::dvec2 place) const {
        return {place.x * right + place.y * up + glm::dot(origin.xyz, normal) * normal};
    }
    /// Looks at it straight on, as near as `camera` is and with its target in the middle.
    Camera straight_on(const Camera& camera) const;
};

FlatPlane flat_plane(const Transform<World, Object>& world_from_object);

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"
#include "core/math/transform.h"
#include "core/surface/surface.h"

#include <glm/mat3x3.hpp>

namespace normalscope {

/// How the grid fades with the square of the distance from the origin, in its own units, and the shadow with that from its
/// centre, in its radii: to nothing where 1 − fade · distance² is 0.
inline constexpr double kGridFade = 0.021, kShadowFade = 0.3;

/// Beneath the lowest point of object and ghost.
float ground_height(const Mesh& mesh, const Transform<World, Object>& world_from_object, bool ghost, double unit);

/// From (x, z, 1) on the ground to the unit disc of the object's shadow; nowhere near it where there is none.
glm::mat3 shadow_from_ground(const Surface& surface, const Transform<World, Object>& world_from_object, double unit);

/// What holds all of a pane's ground that shows grid or shadow: beyond it is sky alone. It may be larger than it must be.
PixelRect ground_box(const Frame& frame, const Pane& pane);

}  // namespace normalscope

#pragma once

#include "core/math/camera.h"
#include "core/math/transform.h"
#include "core/surface/surface.h"

#include <algorithm>

namespace normalscope {

/// How many world units arrows, marks and the grid take for one: 1, but for objects that are many times larger or smaller,
/// beside which they would be lost, or which they would hide.
double picture_unit(const Surface& surface, const Transform<World, Object>& world_from_object);
/// The same beside something of that radius.
double picture_unit(double radius);

/// How far from the eye the object reaches, along the view's axis; 0 where all of it lies behind the eye.
double farthest_depth(const Surface& surface, const Transform<World, Object>& world_from_object,
                      const CameraView& view);

/// The largest |x|, |y| and |z| that is drawn in object space: a formula's surface goes beyond its mesh.
glm::dvec3 drawn_extent(const Surface& surface);

/// A matrix that floats hold, which reach to 1e38: what is done beyond that cannot be seen anyway.
template <class M>
M drawable(const M& m) {
    M result = m;
    for (int c = 0; c < M::length(); ++c)
        for (int r = 0; r < M::col_type::length(); ++r) result[c][r] = std::clamp(m[c][r], -1e15, 1e15);
    return result;
}

}  // namespace normalscope

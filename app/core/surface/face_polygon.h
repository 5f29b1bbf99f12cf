#pragma once

#include "core/surface/probe.h"
#include "core/surface/surface.h"

namespace normalscope {

/// The probe with a polygon H in its tangent plane, whose first two edges are its tangents, as long as they are: what slides
/// draw in place of a plane. Where the mesh is flat H is its face, of as many coplanar triangles as there are; where that is
/// curved, concave, has more than eight corners or is too small to be seen, a pentagon about the point. As it is where it has
/// no normal.
Probe with_polygon(const Probe& probe, const Surface& surface);

}  // namespace normalscope

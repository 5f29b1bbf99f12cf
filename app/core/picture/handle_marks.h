#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"
#include "core/math/transform.h"

namespace normalscope {

/// The object's axes with their letters, and where there are handles the knobs at their ends. `extent` is the surface's.
void add_axes(Pane& pane, const Scene& scene, const glm::dvec3& extent, const FrameOptions& options);

/// What else can be dragged: the ray's ends, the slice.
void add_knobs(Pane& pane, const Scene& scene, const Transform<World, Object>& m, const FrameOptions& options);

}  // namespace normalscope

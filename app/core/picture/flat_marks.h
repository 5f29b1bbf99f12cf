#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// Makes the frame's one pane look straight at the plane to which M takes z = 0, and draws all that a flat view has: graph
/// paper, the axes, the curve before and after M, its arrows, and what belongs to the probe, which stands on the curve.
void add_flat_view(Frame& frame, const Scene& scene, const Transform<World, Object>& world_from_object,
                   const FrameOptions& options);

/// Once the frame has its legend: the view's sentence at the bottom, beside that or above it. Nothing has a surface's colours.
void end_flat_view(Frame& frame, const FrameOptions& options);

}  // namespace normalscope

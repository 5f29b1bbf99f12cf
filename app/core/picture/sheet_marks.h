#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// The probe's normal as a stack of three sheets, carried by M as points are, and how many of them a step along each axis
/// and one along the surface cross. On the ghost, too, where there is one.
void add_sheet_marks(Pane& pane, const Scene& scene, const Frame& frame,
                     const Transform<World, Object>& world_from_object, bool ghost, const FrameOptions& options);

}  // namespace normalscope

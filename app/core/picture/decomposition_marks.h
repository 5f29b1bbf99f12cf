#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// Adds the three perpendicular directions that M only stretches, as long as their factors, and the surface's normal
/// that the naive rule treats worst, with both of its images and the angle between them.
void add_decomposition_marks(Pane& pane, const Scene& scene, const Mesh& mesh,
                             const Transform<World, Object>& world_from_object, const FrameOptions& options);

}  // namespace normalscope

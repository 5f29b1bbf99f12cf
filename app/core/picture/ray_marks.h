#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// The ray as far as it has been followed: in the world, and in grey in object space.
void add_ray_marks(Pane& pane, const Scene& scene, const RaySteps& ray,
                   const Transform<World, Object>& world_from_object, bool ghost, const FrameOptions& options);

}  // namespace normalscope

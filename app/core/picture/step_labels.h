#pragma once

#include "core/frame/frame_options.h"

namespace normalscope {

/// The words that a lesson's step puts at places of the picture, where they lie on nothing else.
void add_step_labels(Pane& pane, const Scene& scene, const Transform<World, Object>& world_from_object,
                     const FrameOptions& options);

}  // namespace normalscope

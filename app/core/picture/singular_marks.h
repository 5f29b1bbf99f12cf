#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// "No normal here", the fan of the normals all around, and the neighbour that lends its own.
void add_singular_marks(Pane& pane, const Scene& scene, const SingularPoint& singular,
                        const Transform<World, Object>& world_from_object, const FrameOptions& options);

}  // namespace normalscope

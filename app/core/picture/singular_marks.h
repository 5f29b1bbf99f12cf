#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// "No normal here", the fan of the normals all around, and the neighbour that lends its own. False where that is no fan: nothing
/// is drawn, or a single normal and its opposite.
bool add_singular_marks(Pane& pane, const Scene& scene, const SingularPoint& singular,
                        const Transform<World, Object>& world_from_object, const FrameOptions& options);

}  // namespace normalscope

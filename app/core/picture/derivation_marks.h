#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// The arrows of the derivation's current line, with their names, on the ghost and on the object.
void add_derivation_marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe,
                          const Transform<World, Object>& world_from_object, const FrameOptions& options);

}  // namespace normalscope

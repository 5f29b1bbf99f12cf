#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// The polygon H in the probe's place, on the ghost where there is one, and MH on the object: with their edge vectors, as far
/// as the derivation has no arrows of its own. Nothing where the probe has none.
void add_polygon_marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe, bool ghost,
                       const FrameOptions& options);

}  // namespace normalscope

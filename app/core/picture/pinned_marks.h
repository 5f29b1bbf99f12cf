#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

#include <vector>

namespace normalscope {

/// The scene's pinned points on the surface, one each; empty where M sends one to infinity or beyond. In a flat
/// view they keep to the curve, as the probe does: `cut` is it.
std::vector<std::optional<ProbeInWorld>> pinned_probes(const Scene& scene, const Surface& surface,
                                                       const Transform<World, Object>& world_from_object,
                                                       double right_power, const FlatCut* cut = nullptr);

/// A dot at each of the frame's, with its number.
void add_pinned_marks(Pane& pane, const Scene& scene, const Frame& frame, const FrameOptions& options);

}  // namespace normalscope

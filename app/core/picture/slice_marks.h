#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"
#include "core/surface/level_sets.h"

namespace normalscope {

/// The colour of a band of level sets: warm inside, cool outside, deeper the farther f is from 0.
glm::vec3 band_color(int band, Theme theme);

/// The level sets as M carries them, with ∇f by the pane's rule, and the plane's knob. Where there is a `ghost`, its own
/// level lines are drawn, too, in grey.
void add_slice(Pane& pane, const Scene& scene, const LevelSets& sets, const Transform<World, Object>& world_from_object,
               bool ghost, const FrameOptions& options);

}  // namespace normalscope

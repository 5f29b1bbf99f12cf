#pragma once

#include "core/scene/scene.h"
#include "core/surface/surface.h"

namespace normalscope {

/// The zoom at which the object fills the picture about the camera's target, with its ghost, its arrows and its axes. 1 where
/// there is nothing to see, and where M is not affine: it may send the object anywhere.
double framing_zoom(const Scene& scene, const Surface& surface);

/// The scene with that zoom, if it says none itself. `surface` is the scene's.
Scene with_zoom(Scene scene, const Surface& surface);

}  // namespace normalscope

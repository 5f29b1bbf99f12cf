#pragma once

#include "core/base/beside.h"
#include "core/image/image.h"
#include "core/surface/implicit_surface.h"

namespace normalscope {

/// A small picture of a formula's surface as the camera sees it untransformed, by the processor alone; transparent
/// where there is none of it. Readable on a light ground and on a dark one. Ends early, half done, when asked to stop.
Image preview(const ImplicitSurface& surface, const Camera& camera, int side, const Stop& stop = {});

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"

namespace normalscope {

/// A box in the framebuffer that holds all of a pane but its backdrop: surfaces, arrows and solids. It may be larger than
/// it must be, and is the whole pane where something reaches behind the eye.
PixelRect drawn_box(const Surface& surface, const Pane& pane);

/// The smallest box that holds both; one without pixels holds nothing.
PixelRect united(const PixelRect& a, const PixelRect& b);

}  // namespace normalscope

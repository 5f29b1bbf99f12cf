#pragma once

#include "core/frame/frame.h"
#include "ui/kit/style.h"

namespace normalscope {

/// The card with what mouse and keys do, over the picture. Closed by its button, by Escape and by a click elsewhere.
void draw_help(const Look& look, const PixelRect& picture, bool& open);

}  // namespace normalscope

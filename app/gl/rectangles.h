#pragma once

// Rectangles as GL counts them: from the lower left.

#include "core/frame/frame.h"
#include "gl/target.h"

#include <array>

namespace normalscope {

/// From the top left, as the picture counts.
PixelRect upright(PixelRect rect, const Target& target);

void scissor(const PixelRect& rect);
/// Viewport and scissor.
void look_at(const PixelRect& rect);

/// Where they have no pixel in common, a rectangle of no size within the first.
PixelRect common(const PixelRect& a, const PixelRect& b);
/// What of a rectangle lies below, above, left and right of a smaller one within it.
std::array<PixelRect, 4> around(const PixelRect& whole, const PixelRect& part);

}  // namespace normalscope

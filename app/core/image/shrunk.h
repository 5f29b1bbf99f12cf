#pragma once

#include "core/image/image.h"

namespace normalscope {

/// Each pixel the mean over `side` × `side` of the picture's, which is also what a smaller picture's samples would give;
/// what is left over at the right and at the bottom is cut off. `side` is at least 1, and no more than either side.
Image shrunk_by(const Image& image, int side);

/// So small, by a whole number, that neither side is longer than `longest` pixels.
Image shrunk(const Image& image, int longest);

}  // namespace normalscope

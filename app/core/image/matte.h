#pragma once

#include "core/image/image.h"

namespace normalscope {

/// What is in front of the ground, from the same picture on black and on white: where they differ one sees through it.
/// Exact for whatever was blended, whoever did it.
Image matte(const Image& on_black, const Image& on_white);

}  // namespace normalscope

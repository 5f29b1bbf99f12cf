#pragma once

#include "core/image/image.h"

#include <glm/vec3.hpp>

namespace normalscope {

/// Of one colour, each channel from 0 to 1.
Image filled(glm::ivec2 size, const glm::vec3& color);

/// From this column on, and down to the last row that holds anything but ground, which its last pixel has.
Image what_is_full(const Image& image, int left);

/// Cut between its lines, its parts side by side, all about as high.
Image in_columns(const Image& image, int columns);

/// On the right of the other, on ground of that colour where it is lower.
Image with_at_right(const Image& image, const Image& right, const glm::vec3& ground);

}  // namespace normalscope

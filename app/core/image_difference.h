#pragma once

#include "core/image.h"

#include <array>
#include <cstdint>

namespace normalscope {

/// How far two pictures of one size are apart. Channels count from 0 to 255; what is wholly transparent in both agrees,
/// whatever colour it would have.
struct ImageDifference {
    std::array<int, 4> most{};       ///< red, green, blue, alpha
    std::array<double, 4> mean{};    ///< over all pixels
    std::int64_t pixels_beyond = 0;  ///< with a channel further off than the tolerance
    double share_beyond = 0.0;       ///< of all pixels
    glm::ivec2 worst{0};             ///< the pixel with the largest difference in any channel, from the top left
    int worst_by = 0;
};

/// The pictures must be of one size.
ImageDifference image_difference(const Image& actual, const Image& expected, int tolerance);

/// Actual, expected and where they differ, side by side on white: red beyond the tolerance, yellow within it, and a
/// frame about the worst spot. Where the sizes differ, what only one of them covers counts as different.
Image difference_picture(const Image& actual, const Image& expected, int tolerance);

}  // namespace normalscope

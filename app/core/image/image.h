#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace normalscope {

/// A picture of 8-bit sRGB with alpha, not premultiplied; the top row comes first.
struct Image {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgba;  ///< 4 · size.x · size.y bytes

    const std::uint8_t* pixel(int x, int y) const {
        return rgba.data() +
               4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
    }
    std::uint8_t* pixel(int x, int y) {
        return const_cast<std::uint8_t*>(static_cast<const Image&>(*this).pixel(x, y));
    }
};

/// Black and transparent.
inline Image make_image(glm::ivec2 size) {
    return {size, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y))};
}

/// The part of `image` from `origin`, which must lie within.
inline Image cropped(const Image& image, glm::ivec2 origin, glm::ivec2 size) {
    Image part = make_image(size);
    for (int y = 0; y < size.y; ++y) std::copy_n(image.pixel(origin.x, origin.y + y), 4 * size.x, part.pixel(0, y));
    return part;
}

// The largest picture that is drawn or read: half a gigabyte of pixels.
inline constexpr int kLongestSide = 16384;
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 27;

}  // namespace normalscope

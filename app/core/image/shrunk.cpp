#include "core/image/shrunk.h"

#include <algorithm>
#include <array>

namespace normalscope {

Image shrunk_by(const Image& image, int side) {
    Image small = make_image(image.size / side);
    for (int y = 0; y < small.size.y; ++y)
        for (int x = 0; x < small.size.x; ++x) {
            std::array<int, 4> sum{};
            for (int v = 0; v < side; ++v) {
                const std::uint8_t* row = image.pixel(x * side, y * side + v);
                for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(side); ++i) sum[i % 4] += row[i];
            }
            for (std::size_t c = 0; c < 4; ++c)
                small.pixel(x, y)[c] = static_cast<std::uint8_t>((sum[c] + side * side / 2) / (side * side));
        }
    return small;
}

Image shrunk(const Image& image, int longest) {
    const int side = (std::max(image.size.x, image.size.y) + longest - 1) / longest;
    return shrunk_by(image, std::clamp(side, 1, std::min(image.size.x, image.size.y)));
}

}  // namespace normalscope

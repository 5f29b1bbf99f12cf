#include "core/image/matte.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

Image matte(const Image& on_black, const Image& on_white) {
    Image result = on_black;
    for (std::size_t i = 0; i + 3 < result.rgba.size(); i += 4) {
        int through = 0;
        for (std::size_t k = 0; k < 3; ++k) through += on_white.rgba[i + k] - on_black.rgba[i + k];
        const double alpha = std::clamp(1.0 - through / (3.0 * 255.0), 0.0, 1.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const double c = alpha > 0.0 ? on_black.rgba[i + k] / alpha : 0.0;
            result.rgba[i + k] = static_cast<std::uint8_t>(std::lround(std::clamp(c, 0.0, 255.0)));
        }
        result.rgba[i + 3] = static_cast<std::uint8_t>(std::lround(255.0 * alpha));
    }
    return result;
}

}  // namespace normalscope

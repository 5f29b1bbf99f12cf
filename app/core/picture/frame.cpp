#include "core/picture/frame.h"

#include "core/scene/palette.h"

#include <glm/common.hpp>

#include <algorithm>

namespace normalscope {

glm::vec3 error_color(double degrees) {
    const double at = std::clamp(degrees / 90.0, 0.0, 1.0) * static_cast<double>(kErrorRamp.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), kErrorRamp.size() - 2);
    return glm::mix(kErrorRamp[low], kErrorRamp[low + 1], static_cast<float>(at - static_cast<double>(low)));
}

}  // namespace normalscope

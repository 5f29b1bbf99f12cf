#include "core/frame/frame.h"

#include "core/scene/palette.h"

#include <glm/common.hpp>

#include <algorithm>

namespace normalscope {

std::optional<std::array<glm::dvec3, 2>> ends_of(const ArrowDraw& draw, const Site& site) {
    const glm::dvec4 base = glm::dmat4(draw.world_from_object) * glm::dvec4(site.point.xyz, 1.0);
    const glm::dvec3 n = draw.normals(site.normal).xyz, from = glm::dvec3(base) / base.w;
    if (!(glm::length(n) > 0.0) || !(base.w > 0.0)) return std::nullopt;
    if (glm::distance(from, glm::dvec3(draw.cleared)) < static_cast<double>(draw.cleared.w)) return std::nullopt;
    return std::array{from, from + static_cast<double>(draw.length) * glm::normalize(n)};
}

glm::vec3 error_color(double degrees) {
    const double at = std::clamp(degrees / 90.0, 0.0, 1.0) * static_cast<double>(kErrorRamp.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), kErrorRamp.size() - 2);
    return glm::mix(kErrorRamp[low], kErrorRamp[low + 1], static_cast<float>(at - static_cast<double>(low)));
}

}  // namespace normalscope

#include "core/frame/arcs.h"

#include "core/math/normal_rules.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

std::vector<glm::dvec3> arc_between(const glm::dvec3& centre, const glm::dvec3& from, const glm::dvec3& to,
                                    double radius) {
    const double angle = glm::radians(angle_degrees(from, to).value_or(0.0));
    const int steps = std::max(3, static_cast<int>(angle / 0.12));
    std::vector<glm::dvec3> arc;
    for (int i = 0; i <= steps; ++i) {
        const double s = static_cast<double>(i) / steps;
        arc.push_back(centre +
                      radius / std::sin(angle) * (std::sin((1.0 - s) * angle) * from + std::sin(s * angle) * to));
    }
    return arc;
}

}  // namespace normalscope

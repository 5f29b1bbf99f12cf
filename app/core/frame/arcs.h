#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace normalscope {

/// Points on the arc about `centre` from one unit vector to another, by spherical linear interpolation (Shoemake, 1985).
/// The vectors must be less than 180° apart, and not parallel.
std::vector<glm::dvec3> arc_between(const glm::dvec3& centre, const glm::dvec3& from, const glm::dvec3& to,
                                    double radius);

}  // namespace normalscope

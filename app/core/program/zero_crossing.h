#pragma once

#include "core/program/program.h"

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace normalscope::formulas {

/// Whether f may change its sign without being 0: over a pole, as 1/x does, or at a jump, as floor(x) does.
bool may_jump(const Program& program);

/// Where between a and b, at which f has different signs, it goes through 0: the part of the way from a. Empty where it
/// goes through infinity, jumps, or has no value.
std::optional<double> zero_between(const Program& program, const glm::dvec3& a, const glm::dvec3& b);

struct Edge {
    glm::dvec3 a, b;
};
/// The same of many, side by side.
std::vector<std::optional<double>> zeros_between(const Program& program, std::span<const Edge> edges);

}  // namespace normalscope::formulas

#pragma once

#include "core/program/program.h"

#include <glm/vec3.hpp>

#include <span>

namespace normalscope::formulas {

/// f as the graphics processor's floats give it: each step rounded to 24 bits, or to nothing where it underflows.
void values_in_floats(const Program& program, std::span<const glm::dvec3> points, std::span<double> values);

}  // namespace normalscope::formulas

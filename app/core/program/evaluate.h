#pragma once

#include "core/program/interval.h"
#include "core/program/program.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>

namespace normalscope::formulas {

/// f and ∇f at a point. NaN where f has no real value; the gradient also where f has no derivative, such as at the tip
/// of sqrt(x²+y²+z²).
struct Sample {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
};

struct Box {
    glm::dvec3 low{0.0}, high{0.0};
};

/// Bounds on f and on each component of ∇f over a box.
struct IntervalSample {
    Interval value;
    std::array<Interval, 3> gradient;
};

double value(const Program& program, glm::dvec3 p);
Sample sample(const Program& program, glm::dvec3 p);
Interval value(const Program& program, const Box& box);
IntervalSample sample(const Program& program, const Box& box);

/// The same for many points, several side by side.
void values(const Program& program, std::span<const glm::dvec3> points, std::span<double> values);
void samples(const Program& program, std::span<const glm::dvec3> points, std::span<Sample> samples);

}  // namespace normalscope::formulas

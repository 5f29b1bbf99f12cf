#pragma once

#include "core/program/evaluate.h"

#include <glm/vec3.hpp>

#include <vector>

namespace normalscope {

/// Newton's steps along the gradient to f = 0, at most so many, for all points side by side. A point stays where its next step
/// would lead farther than `reach` from where it began. Gives f and ∇f at what has become of the points.
std::vector<formulas::Sample> newton_steps(const formulas::Program& program, std::vector<glm::dvec3>& points, int most,
                                           double reach);

/// Onto f = 0 and the ball around 0 of that radius at once, by at most so many of Newton's steps, each shorter than `reach`.
glm::dvec3 onto_ball(const formulas::Program& program, double radius, glm::dvec3 p, int most, double reach);

}  // namespace normalscope

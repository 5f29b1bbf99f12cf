#pragma once

#include "core/formula/program.h"

#include <string>

namespace normalscope::formulas {

/// The formula for the graphics processor, in what GLSL 3.30 and GLSL ES 3.00 have in common. `compile` it without
/// values for the parameters: they are uniforms, so that a slider needs no new shader.
struct Glsl {
    /// Declares `uniform float formula_a;` for each parameter that occurs, and defines
    ///     float f(vec3 p)
    ///     vec3 gradient(vec3 p)        by reverse accumulation; it shares what f computes on the way
    ///     bool is_defined(vec3 p)      false where f has no real value; f and gradient have some value even there, no NaN
    std::string source;
    bool defined_everywhere = true;  ///< is_defined is always true
};

Glsl to_glsl(const Program& program);

}  // namespace normalscope::formulas

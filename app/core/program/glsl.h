#pragma once

#include "core/program/program.h"

#include <string>

namespace normalscope::formulas {

/// What the graphics processor computes with. Double needs the extension ARB_gpu_shader_fp64, which has no functions but
/// roots: the others are in shaders/functions.glsl.
enum class Precision { Single, Double };

/// The formula for the graphics processor, in what GLSL 3.30 and GLSL ES 3.00 have in common. `compile` it without
/// values for the parameters: they are uniforms, so that a slider needs no new shader.
struct Glsl {
    /// Wants shaders/functions.glsl before it, with DOUBLES defined for Precision::Double. Declares `uniform float formula_a;`
    /// for each parameter that occurs, and defines, with REAL and REAL3 as float and vec3, or as double and dvec3,
    ///     REAL f(REAL3 p)
    ///     REAL3 gradient(REAL3 p)      by reverse accumulation; it shares what f computes on the way
    ///     bool is_defined(REAL3 p)     false where f has no real value; f and gradient have some value even there, no NaN
    std::string source;
    bool defined_everywhere = true;  ///< is_defined is always true
};

Glsl to_glsl(const Program& program, Precision precision = Precision::Single);

}  // namespace normalscope::formulas

#pragma once

#include "core/program/glsl.h"

#include <string>
#include <vector>

namespace normalscope::formulas {

// A function on [0, 1] from its values at a few places there: how the graphics processor bounds f along a part of a ray.

/// The Chebyshev points with both ends, ascending; degree + 1 of them. An interpolant through them is within a small
/// factor of the best one. (Trefethen, "Approximation Theory and Approximation Practice", chapters 2 and 15.)
std::vector<double> chebyshev_points(int degree);

/// Row i gives the i-th Bernstein coefficient of the interpolant from its values at the Chebyshev points.
std::vector<std::vector<double>> bernstein_from_samples(int degree);

/// Row 0 and 1 give its last and last but one Chebyshev coefficient: how much the interpolant's error is.
std::vector<std::vector<double>> last_chebyshev_coefficients(int degree);

/// In GLSL, with REAL for float or double: `DEGREE`, the points as `float point(int i)`, and
///     void to_bernstein(REAL s[DEGREE + 1], out REAL b[DEGREE + 1])
///     REAL last_terms(REAL s[DEGREE + 1])     the sizes of the last two Chebyshev coefficients, added up
///     const REAL ROUNDING                        of the largest |s|: how far rounding may move a coefficient
std::string ray_samples_glsl(int degree, Precision precision = Precision::Single);

}  // namespace normalscope::formulas

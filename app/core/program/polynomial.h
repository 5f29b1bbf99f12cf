#pragma once

#include "core/formula/graph.h"
#include "core/program/program.h"

#include <glm/vec3.hpp>

#include <array>
#include <map>
#include <optional>

namespace normalscope::formulas {

inline constexpr int kMostDegree = 24;

/// Σ coefficient · x^i y^j z^k, highest powers first.
struct Polynomial {
    using Exponents = std::array<int, 3>;
    std::map<Exponents, Number, std::greater<>> terms;  ///< none is zero
    bool exact = true;                                  ///< every number in it is a fraction

    int degree() const;  ///< the total degree; 0 for a constant, and for 0
};

/// The expression, multiplied out. Empty where it is no polynomial, or of a degree beyond kMostDegree.
std::optional<Polynomial> polynomial(const Graph& graph, Id root,
                                     const std::optional<Parameters>& parameters = std::nullopt);

/// f(o + t d) = Σ c[k] t^k.
struct RayPolynomial {
    std::array<double, kMostDegree + 1> c{};
    int degree = 0;
    double noise = 0.0;  ///< how far rounding may have moved f for |t| ≤ 1
};

/// By polynomial arithmetic, step for step, so no digits are lost to sampling; empty where the program is no polynomial.
/// Let t run from −1 to 1 over the part of the ray that matters: there rounding is least.
std::optional<RayPolynomial> along_ray(const Program& program, glm::dvec3 o, glm::dvec3 d);

}  // namespace normalscope::formulas

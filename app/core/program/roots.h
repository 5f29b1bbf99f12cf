#pragma once

#include "core/program/evaluate.h"
#include "core/program/polynomial.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace normalscope::formulas {

/// Where f(o + t d) = 0.
struct Root {
    double t = 0.0;
    bool touches = false;  ///< f has one sign on both sides: the ray grazes the surface, or runs within it
};

enum class Wanted { First, All };

/// What many rays together may cost, in instructions of the program; a ray that comes when all is spent meets nothing.
struct Effort {
    std::int64_t left;
};

/// Roots of polynomials of one degree on [−1, 1], in order. Bernstein coefficients bound a polynomial and, by
/// Descartes' rule, count its roots; de Casteljau's algorithm halves the interval until each part has none or one.
/// (Farouki, "The Bernstein polynomial basis: a centennial retrospective", 2012; Rouillier and Zimmermann, "Efficient
/// isolation of polynomial's real roots", 2004.) What rounding cannot tell from zero counts as zero, so that a ray that
/// only touches the surface meets it.
class RootFinder {
public:
    explicit RootFinder(int degree);
    /// `noise` is what the coefficients' own errors may add up to. Multiple roots are found once.
    std::vector<Root> operator()(const RayPolynomial& p, Wanted wanted) const;

    /// Σ c[k] t^k as Σ b[i] B_i on [−1, 1].
    std::vector<double> bernstein(const RayPolynomial& p) const;

private:
    int degree_;
    std::vector<double> from_power_;  // row i, column k; no entry is above 1, so nothing is magnified
};

/// Meets rays with f = 0: polynomials by their roots, anything else by intervals that are halved until f is monotonic
/// or has no zero there.
class RayTracer {
public:
    /// The program has values for its parameters (compile).
    explicit RayTracer(Program program);

    /// The hits with from ≤ t ≤ to, in order. Only the search by intervals spends effort.
    std::vector<Root> hits(glm::dvec3 o, glm::dvec3 d, double from, double to, Wanted wanted,
                           Effort* effort = nullptr) const;

    bool is_polynomial() const { return finder_.has_value(); }

private:
    Program program_;
    std::optional<RootFinder> finder_;
};

/// The general way, for any program.
std::vector<Root> roots_by_intervals(const Program& program, glm::dvec3 o, glm::dvec3 d, double from, double to,
                                     Wanted wanted, Effort* effort = nullptr);

/// A root of f between a and b, where its signs differ, to the last digits. Newton's steps where they stay between,
/// halving where they do not. `f` returns the value and the derivative.
template <class F>
double refined(F&& f, double a, double b) {
    double t = 0.5 * (a + b);
    const bool rising = f(a).first < 0.0;
    for (int i = 0; i < 100 && a < t && t < b; ++i) {
        const auto [v, slope] = f(t);
        if (v == 0.0) return t;
        ((v < 0.0) == rising ? a : b) = t;
        const double step = t - v / slope;
        // Newton's alone may creep up from one side: every fourth step halves.
        const double next = a < step && step < b && i % 4 != 3 ? step : 0.5 * (a + b);
        if (next == t) break;
        t = next;
    }
    return t;
}

}  // namespace normalscope::formulas

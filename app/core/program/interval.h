#pragma once

#include "core/formula/real.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope::formulas {

/// Bounds on an expression's values over a box. Every operation rounds outward, so the bounds hold for what doubles
/// compute as well as for real numbers. They are never NaN; where nothing is known they are infinite.
struct Interval {
    /// Where in the box the expression has a value. "Somewhere" is a maybe: the bounds are those of the values it has.
    enum class Defined : std::uint8_t { Nowhere, Somewhere, Everywhere };

    double low = 0.0, high = 0.0;
    Defined defined = Defined::Everywhere;

    Interval() = default;
    Interval(double value) : low(value), high(value) {
        if (std::isfinite(value)) return;
        const double infinite = std::numeric_limits<double>::infinity();
        *this = {-infinite, infinite, std::isnan(value) ? Defined::Nowhere : Defined::Somewhere};
    }
    Interval(double from, double to, Defined d = Defined::Everywhere) : low(from), high(to), defined(d) {}

    bool contains(double v) const { return low <= v && v <= high; }
    double width() const { return high - low; }
    double middle() const { return 0.5 * low + 0.5 * high; }
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline Interval::Defined least(const Interval& a, const Interval& b) { return std::min(a.defined, b.defined); }

/// Wider by `ulps` units in the last place, and by the smallest doubles; NaN, as ∞ − ∞ gives it, becomes infinite. What has
/// overflowed is large, not unknown.
inline Interval outward(double low, double high, Interval::Defined defined, double ulps = 1.0) {
    constexpr double kUlp = std::numeric_limits<double>::epsilon(), kTiny = std::numeric_limits<double>::denorm_min();
    constexpr double kLargest = std::numeric_limits<double>::max();
    low = std::min(low, kLargest);
    high = std::max(high, -kLargest);
    low = low - (ulps * kUlp * std::abs(low) + ulps * kTiny);
    high = high + (ulps * kUlp * std::abs(high) + ulps * kTiny);
    return {std::isnan(low) ? -kInfinity : low, std::isnan(high) ? kInfinity : high, defined};
}

inline Interval operator+(const Interval& a, const Interval& b) {
    return outward(a.low + b.low, a.high + b.high, least(a, b));
}
inline Interval operator-(const Interval& a, const Interval& b) {
    return outward(a.low - b.high, a.high - b.low, least(a, b));
}
inline Interval operator-(const Interval& a) { return {-a.high, -a.low, a.defined}; }

inline Interval operator*(const Interval& a, const Interval& b) {
    // An infinite bound stands for values that are large but finite: times 0 they are 0.
    const auto times = [](double s, double t) { return s == 0.0 || t == 0.0 ? 0.0 : s * t; };
    const double p = times(a.low, b.low), q = times(a.low, b.high), r = times(a.high, b.low), s = times(a.high, b.high);
    return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)), least(a, b));
}
inline Interval& operator+=(Interval& a, const Interval& b) { return a = a + b; }

Interval operator/(const Interval& a, const Interval& b);
Interval hull(const Interval& a, const Interval& b);

Interval power(const Interval& base, double exponent, Parity parity);
Interval power(const Interval& base, const Interval& exponent);
Interval exp(const Interval& a);
Interval log(const Interval& a);
Interval sin(const Interval& a);
Interval cos(const Interval& a);
Interval tan(const Interval& a);
Interval asin(const Interval& a);
Interval acos(const Interval& a);
Interval atan(const Interval& a);
Interval sinh(const Interval& a);
Interval cosh(const Interval& a);
Interval tanh(const Interval& a);
Interval asinh(const Interval& a);
Interval acosh(const Interval& a);
Interval atanh(const Interval& a);
Interval abs(const Interval& a);
Interval atan2(const Interval& y, const Interval& x);
Interval sign(const Interval& a);
Interval floor(const Interval& a);
Interval min(const Interval& a, const Interval& b);
Interval max(const Interval& a, const Interval& b);
Interval where(const Interval& a, const Interval& c, const Interval& b);  ///< a where c ≤ 0, else b

/// Sign and where as derivatives of |a|, min and max. As functions they jump, which counts as a place without a value; a
/// derivative that jumps is a kink, at which any slope between is as good.
Interval slope_of_abs(const Interval& a);
Interval slope_where(const Interval& a, const Interval& c, const Interval& b);

}  // namespace normalscope::formulas

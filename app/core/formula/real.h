#pragma once

#include "core/formula/number.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope::formulas {

/// What a power with a constant exponent does for a negative base: p/q with odd q is a real root, even or odd as p is.
enum class Parity : std::uint8_t { None, Even, Odd };

inline Parity parity(const Number& exponent) {
    if (exponent.integer()) return exponent.even() ? Parity::Even : Parity::Odd;
    if (!exponent.exact() || exponent.denominator() % 2 == 0) return Parity::None;
    return exponent.numerator() % 2 == 0 ? Parity::Even : Parity::Odd;
}

/// That of the derivative, whose exponent is less by one.
inline Parity flipped(Parity p) { return p == Parity::None ? p : p == Parity::Even ? Parity::Odd : Parity::Even; }

/// The operations on doubles. What has no real value is NaN, 1/0 included.
namespace real {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Never 0, also where the result is too small for a double: what is so for all x must not look like a surface.
inline double exp(double v) { return std::max(std::exp(v), std::numeric_limits<double>::min()); }

inline double sign(double v) { return v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : v; }

/// The angle of (x, y), from −π to π: the origin has none.
inline double atan2(double y, double x) { return x == 0.0 && y == 0.0 ? kNaN : std::atan2(y, x); }

/// By squaring: for exponents as formulas have them it is faster than std::pow.
inline double integer_power(double base, double exponent) {
    if (exponent < 0.0 && base == 0.0) return kNaN;
    if (std::abs(exponent) > 64.0) return std::pow(base, exponent);
    double result = 1.0;
    for (auto n = static_cast<unsigned>(std::abs(exponent)); n != 0; n >>= 1) {
        if (n & 1) result *= base;
        base *= base;
    }
    return exponent < 0.0 ? 1.0 / result : result;
}

inline double power(double base, double exponent, Parity parity) {
    if (std::floor(exponent) == exponent) return integer_power(base, exponent);
    if ((base == 0.0 && exponent < 0.0) || (base < 0.0 && parity == Parity::None)) return kNaN;
    const double size = std::pow(std::abs(base), exponent);
    return base < 0.0 && parity == Parity::Odd ? -size : size;
}

/// For an exponent that varies: a negative base has a value only where it is a whole number.
inline double power(double base, double exponent) {
    return base == 0.0 && exponent <= 0.0 ? kNaN : std::pow(base, exponent);
}

}  // namespace real

}  // namespace normalscope::formulas

#include "core/program/interval.h"

#include <numbers>

namespace normalscope::formulas {

namespace {

using Defined = Interval::Defined;

constexpr double kLibrary = 4.0;  // ulps by which the C library's functions may be off, with a margin

Interval nowhere() { return {-kInfinity, kInfinity, Defined::Nowhere}; }

// The part of `a` within [low, high]; nothing there: Nowhere.
Interval clipped(const Interval& a, double low, double high) {
    if (a.defined == Defined::Nowhere || a.high < low || a.low > high) return nowhere();
    const bool inside = a.low >= low && a.high <= high;
    return {std::max(a.low, low), std::min(a.high, high), inside ? a.defined : Defined::Somewhere};
}

template <class F>
Interval rising(const Interval& a, F&& f) {
    if (a.defined == Defined::Nowhere) return nowhere();
    return outward(f(a.low), f(a.high), a.defined, kLibrary);
}

// Does a multiple of 2π, shifted, lie within? Asked a little too generously: rounding may only add one.
bool reaches(const Interval& a, double shift) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double slack = 1e-12 + 1e-15 * std::max(std::abs(a.low), std::abs(a.high));
    return std::floor((a.high + slack - shift) / kTurn) >= std::ceil((a.low - slack - shift) / kTurn);
}

bool too_wide(const Interval& a, double period) {
    return !(a.width() < period) || std::max(std::abs(a.low), std::abs(a.high)) > 1e9;
}

Interval wave(const Interval& a, double crest, double (*f)(double)) {
    if (a.defined == Defined::Nowhere) return nowhere();
    if (too_wide(a, 2.0 * std::numbers::pi)) return {-1.0, 1.0, a.defined};
    const double p = f(a.low), q = f(a.high);
    const double low = reaches(a, crest + std::numbers::pi) ? -1.0 : std::min(p, q);
    const double high = reaches(a, crest) ? 1.0 : std::max(p, q);
    const Interval wide = outward(low, high, a.defined, kLibrary);
    return {std::max(wide.low, -1.0), std::min(wide.high, 1.0), a.defined};
}

double library_power(double base, double exponent) { return real::power(base, exponent, Parity::None); }

// For a base that is not negative.
Interval positive_power(const Interval& base, double exponent) {
    const double ulps = kLibrary + 2.0 * std::min(std::abs(exponent), 64.0);  // as many roundings as factors
    const double p = library_power(base.low, exponent), q = library_power(base.high, exponent);
    if (exponent > 0.0) {
        const Interval wide = outward(p, q, base.defined, ulps);
        return {std::max(wide.low, 0.0), wide.high, base.defined};
    }
    if (base.high == 0.0) return nowhere();
    const Interval wide =
        outward(base.high == kInfinity ? 0.0 : q, base.low == 0.0 ? kInfinity : p, base.defined, ulps);
    return {std::max(wide.low, 0.0), wide.high,
            base.low == 0.0 ? std::min(base.defined, Defined::Somewhere) : base.defined};
}

}  // namespace

Interval hull(const Interval& a, const Interval& b) {
    if (a.defined == Defined::Nowhere && b.defined == Defined::Nowhere) return nowhere();
    if (a.defined == Defined::Nowhere) return {b.low, b.high, Defined::Somewhere};
    if (b.defined == Defined::Nowhere) return {a.low, a.high, Defined::Somewhere};
    return {std::min(a.low, b.low), std::max(a.high, b.high), least(a, b)};
}

Interval operator/(const Interval& a, const Interval& b) {
    const Interval reciprocal = power(b, -1.0, Parity::Odd);
    if (reciprocal.defined == Defined::Nowhere || a.defined == Defined::Nowhere) return nowhere();
    if (b.low > 0.0 || b.high < 0.0) {  // a quotient is rounded once; its bounds are among the four
        const double p = a.low / b.low, q = a.low / b.high, r = a.high / b.low, s = a.high / b.high;
        if (!std::isnan(p + q + r + s) && std::isfinite(b.width()))
            return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)),
                           least(a, b));
    }
    const Interval product = a * reciprocal;
    return outward(product.low, product.high, product.defined, 2.0);
}

Interval power(const Interval& base, double exponent, Parity parity) {
    if (base.defined == Defined::Nowhere) return nowhere();
    if (exponent == 0.0) return {1.0, 1.0, base.defined};
    const Interval right = clipped(base, 0.0, kInfinity);
    if (parity == Parity::None || base.low >= 0.0)
        return right.defined == Defined::Nowhere ? right : positive_power(right, exponent);
    const Interval left = clipped(-base, 0.0, kInfinity);  // the negative part, mirrored
    Interval mirrored = positive_power({left.low, left.high, base.defined}, exponent);
    if (parity == Parity::Odd) mirrored = -mirrored;
    if (base.high <= 0.0) return mirrored;
    return hull(mirrored, positive_power({right.low, right.high, base.defined}, exponent));
}

Interval power(const Interval& base, const Interval& exponent) {
    if (base.defined == Defined::Nowhere || exponent.defined == Defined::Nowhere) return nowhere();
    const double most = std::max(std::abs(base.low), std::abs(base.high));
    const double least_base = std::max(base.low, 0.0);
    // |base|^exponent over the sizes of the base; it is monotone in each, so the corners bound it.
    double low = kInfinity, high = 0.0;
    for (const double b : {base.low < 0.0 ? 0.0 : least_base, most})
        for (const double e : {exponent.low, exponent.high}) {
            const double v = b == 0.0 ? (e > 0.0 ? 0.0 : e < 0.0 ? kInfinity : 1.0) : std::pow(b, e);
            low = std::isnan(v) ? 0.0 : std::min(low, v);
            high = std::isnan(v) ? kInfinity : std::max(high, v);
        }
    if (base.low <= 0.0 && exponent.low <= 0.0 && exponent.high >= 0.0) {
        low = 0.0;
        high = std::max(high, 1.0);
    }
    // A negative base has values where the exponent is a whole number, of either sign.
    const bool whole = base.low < 0.0;
    const Defined d = base.low > 0.0 ? least(base, exponent) : std::min(least(base, exponent), Defined::Somewhere);
    const Interval wide = outward(low, high, d, kLibrary);
    return {whole ? -wide.high : std::max(wide.low, 0.0), wide.high, d};
}

Interval exp(const Interval& a) {
    const Interval wide = rising(a, real::exp);
    const double least = std::numeric_limits<double>::min();  // as real::exp has it
    return {wide.defined == Defined::Nowhere ? wide.low : std::max(wide.low, least), wide.high, wide.defined};
}

Interval log(const Interval& a) {
    Interval inside = clipped(a, 0.0, kInfinity);
    if (inside.defined == Defined::Nowhere || a.high == 0.0) return nowhere();
    if (a.low <= 0.0) inside.defined = Defined::Somewhere;
    return rising(inside, [](double v) { return std::log(v); });
}

Interval sin(const Interval& a) { return wave(a, 0.5 * std::numbers::pi, std::sin); }
Interval cos(const Interval& a) { return wave(a, 0.0, std::cos); }

Interval tan(const Interval& a) {
    if (a.defined == Defined::Nowhere) return nowhere();
    const double quarter = 0.5 * std::numbers::pi;
    if (too_wide(a, std::numbers::pi) || reaches(a, quarter) || reaches(a, -quarter))
        return {-kInfinity, kInfinity, Defined::Somewhere};
    return rising(a, [](double v) { return std::tan(v); });
}

Interval asin(const Interval& a) {
    return rising(clipped(a, -1.0, 1.0), [](double v) { return std::asin(v); });
}
Interval acos(const Interval& a) {
    return -rising(clipped(a, -1.0, 1.0), [](double v) { return -std::acos(v); });
}
Interval atan(const Interval& a) {
    return rising(a, [](double v) { return std::atan(v); });
}

Interval sinh(const Interval& a) {
    return rising(a, [](double v) { return std::sinh(v); });
}
Interval cosh(const Interval& a) {
    const Interval wide = rising(abs(a), [](double v) { return std::cosh(v); });
    return {wide.defined == Defined::Nowhere ? wide.low : std::max(wide.low, 1.0), wide.high, wide.defined};
}
Interval tanh(const Interval& a) {
    return rising(a, [](double v) { return std::tanh(v); });
}
Interval asinh(const Interval& a) {
    return rising(a, [](double v) { return std::asinh(v); });
}
Interval acosh(const Interval& a) {
    return rising(clipped(a, 1.0, kInfinity), [](double v) { return std::acosh(v); });
}
Interval atanh(const Interval& a) {
    Interval inside = clipped(a, -1.0, 1.0);
    if (inside.defined == Defined::Nowhere || a.high == -1.0 || a.low == 1.0) return nowhere();
    if (a.low <= -1.0 || a.high >= 1.0) inside.defined = Defined::Somewhere;
    return rising(inside, [](double v) { return std::atanh(v); });
}

Interval abs(const Interval& a) {
    if (a.low >= 0.0) return a;
    if (a.high <= 0.0) return -a;
    return {0.0, std::max(-a.low, a.high), a.defined};
}
Interval atan2(const Interval& y, const Interval& x) {
    if (y.defined == Defined::Nowhere || x.defined == Defined::Nowhere) return nowhere();
    constexpr double kHalfTurn = std::numbers::pi;
    const Defined defined = least(y, x);
    // It jumps across the negative x axis.
    if (y.low <= 0.0 && y.high >= 0.0 && x.low <= 0.0)
        return outward(-kHalfTurn, kHalfTurn, std::min(defined, Defined::Somewhere), kLibrary);
    double low = kInfinity, high = -kInfinity;
    for (const double v : {y.low, y.high})
        for (const double u : {x.low, x.high}) {
            low = std::min(low, std::atan2(v, u));
            high = std::max(high, std::atan2(v, u));
        }
    return outward(low, high, defined, kLibrary);
}

Interval sign(const Interval& a) {
    const Interval sides = slope_of_abs(a);
    return {sides.low, sides.high, sides.low < sides.high ? std::min(a.defined, Defined::Somewhere) : a.defined};
}
Interval floor(const Interval& a) {
    if (a.defined == Defined::Nowhere) return nowhere();
    const double low = std::floor(a.low), high = std::floor(a.high);
    return {low, high, low < high ? std::min(a.defined, Defined::Somewhere) : a.defined};
}
Interval slope_of_abs(const Interval& a) {
    return {a.low > 0.0 ? 1.0 : a.low < 0.0 ? -1.0 : 0.0, a.high > 0.0 ? 1.0 : a.high < 0.0 ? -1.0 : 0.0, a.defined};
}
Interval min(const Interval& a, const Interval& b) {
    return {std::min(a.low, b.low), std::min(a.high, b.high), least(a, b)};
}
Interval max(const Interval& a, const Interval& b) {
    return {std::max(a.low, b.low), std::max(a.high, b.high), least(a, b)};
}

Interval slope_where(const Interval& a, const Interval& c, const Interval& b) {
    if (c.defined == Defined::Nowhere) return nowhere();
    Interval result = c.high <= 0.0 ? a : c.low > 0.0 ? b : hull(a, b);
    result.defined = least(result, c);
    return result;
}

Interval where(const Interval& a, const Interval& c, const Interval& b) {
    Interval result = slope_where(a, c, b);
    if (c.low <= 0.0 && c.high > 0.0) result.defined = std::min(result.defined, Defined::Somewhere);
    return result;
}

}  // namespace normalscope::formulas

#include "core/program/evaluate.h"

#include "core/program/points_in_parts.h"
#include "core/program/steps.h"

#include <vector>

namespace normalscope::formulas {

namespace {

constexpr std::size_t kLanes = 8;

// Eight doubles in step: the compiler turns their loops into vector instructions, and a program's steps are decoded
// once for all of them.
struct Lanes {
    std::array<double, kLanes> v;

    Lanes() = default;
    explicit Lanes(double value) { v.fill(value); }
    explicit Lanes(const std::array<double, kLanes>& values) : v(values) {}
};

template <class F>
Lanes each(F&& f) {
    Lanes result;
    for (std::size_t k = 0; k < kLanes; ++k) result.v[k] = f(k);
    return result;
}

#define NORMALSCOPE_EACH(expression) each([&](std::size_t k) { return expression; })
Lanes operator+(const Lanes& a, const Lanes& b) { return NORMALSCOPE_EACH(a.v[k] + b.v[k]); }
Lanes operator-(const Lanes& a, const Lanes& b) { return NORMALSCOPE_EACH(a.v[k] - b.v[k]); }
Lanes operator-(const Lanes& a) { return NORMALSCOPE_EACH(-a.v[k]); }
Lanes operator*(const Lanes& a, const Lanes& b) { return NORMALSCOPE_EACH(a.v[k] * b.v[k]); }
Lanes operator/(const Lanes& a, const Lanes& b) { return NORMALSCOPE_EACH(a.v[k] / b.v[k]); }
Lanes& operator+=(Lanes& a, const Lanes& b) { return a = a + b; }
Lanes power(const Lanes& a, double exponent, Parity parity) {
    if (exponent == 1.0) return a;
    if (exponent == 2.0) return a * a;
    return NORMALSCOPE_EACH(real::power(a.v[k], exponent, parity));
}
Lanes power(const Lanes& a, const Lanes& b) { return NORMALSCOPE_EACH(real::power(a.v[k], b.v[k])); }
Lanes exp(const Lanes& a) { return NORMALSCOPE_EACH(real::exp(a.v[k])); }
Lanes sqrt(const Lanes& a) { return NORMALSCOPE_EACH(std::sqrt(a.v[k])); }
Lanes log(const Lanes& a) { return NORMALSCOPE_EACH(real::log(a.v[k])); }
Lanes sin(const Lanes& a) { return Lanes(sines(a.v, 0)); }
Lanes cos(const Lanes& a) { return Lanes(sines(a.v, 1)); }
Lanes tan(const Lanes& a) { return NORMALSCOPE_EACH(std::tan(a.v[k])); }
Lanes asin(const Lanes& a) { return NORMALSCOPE_EACH(std::asin(a.v[k])); }
Lanes acos(const Lanes& a) { return NORMALSCOPE_EACH(std::acos(a.v[k])); }
Lanes atan(const Lanes& a) { return NORMALSCOPE_EACH(std::atan(a.v[k])); }
Lanes sinh(const Lanes& a) { return NORMALSCOPE_EACH(std::sinh(a.v[k])); }
Lanes cosh(const Lanes& a) { return NORMALSCOPE_EACH(std::cosh(a.v[k])); }
Lanes tanh(const Lanes& a) { return NORMALSCOPE_EACH(std::tanh(a.v[k])); }
Lanes asinh(const Lanes& a) { return NORMALSCOPE_EACH(std::asinh(a.v[k])); }
Lanes acosh(const Lanes& a) { return NORMALSCOPE_EACH(std::acosh(a.v[k])); }
Lanes atanh(const Lanes& a) { return NORMALSCOPE_EACH(std::atanh(a.v[k])); }
Lanes abs(const Lanes& a) { return NORMALSCOPE_EACH(std::abs(a.v[k])); }
Lanes sign(const Lanes& a) { return NORMALSCOPE_EACH(real::sign(a.v[k])); }
Lanes floor(const Lanes& a) { return NORMALSCOPE_EACH(std::floor(a.v[k])); }
Lanes atan2(const Lanes& a, const Lanes& b) { return NORMALSCOPE_EACH(real::atan2(a.v[k], b.v[k])); }
Lanes min(const Lanes& a, const Lanes& b) { return NORMALSCOPE_EACH(real::min(a.v[k], b.v[k])); }
Lanes max(const Lanes& a, const Lanes& b) { return NORMALSCOPE_EACH(real::max(a.v[k], b.v[k])); }
Lanes where(const Lanes& a, const Lanes& c, const Lanes& b) {
    return NORMALSCOPE_EACH(real::where(a.v[k], c.v[k], b.v[k]));
}
Lanes slope_of_abs(const Lanes& a) { return sign(a); }
Lanes slope_where(const Lanes& a, const Lanes& c, const Lanes& b) { return where(a, c, b); }
#undef NORMALSCOPE_EACH

// The points from `begin`; the last one again where they end.
std::array<Lanes, 3> gathered(std::span<const glm::dvec3> points, std::size_t begin) {
    std::array<Lanes, 3> at;
    for (std::size_t k = 0; k < kLanes; ++k)
        for (std::size_t i = 0; i < 3; ++i)
            at[i].v[k] = points[std::min(begin + k, points.size() - 1)][static_cast<glm::length_t>(i)];
    return at;
}

std::array<Interval, 3> intervals(const Box& box) {
    return {Interval{box.low.x, box.high.x}, Interval{box.low.y, box.high.y}, Interval{box.low.z, box.high.z}};
}

// 1/0 is infinite in the middle of a computation; as a result it has no real value.
double real_or_nan(double v) { return std::isfinite(v) ? v : real::kNaN; }

}  // namespace

double value(const Program& program, glm::dvec3 p) {
    std::vector<double> scratch(program.size());
    forward<double>(program, {p.x, p.y, p.z}, scratch);
    return real_or_nan(scratch.back());
}

Sample sample(const Program& program, glm::dvec3 p) {
    std::vector<double> scratch(2 * program.size());
    const std::span<double> v(scratch.data(), program.size());
    forward<double>(program, {p.x, p.y, p.z}, v);
    const std::array<double, 3> g = reverse<double>(program, v, {scratch.data() + program.size(), program.size()});
    return {real_or_nan(v.back()), {g[0], g[1], g[2]}};
}

Interval value(const Program& program, const Box& box) {
    std::vector<Interval> scratch(program.size());
    forward<Interval>(program, intervals(box), scratch);
    return scratch.back();
}

IntervalSample sample(const Program& program, const Box& box) {
    std::vector<Interval> scratch(2 * program.size());
    const std::span<Interval> v(scratch.data(), program.size());
    forward<Interval>(program, intervals(box), v);
    return {v.back(), reverse<Interval>(program, v, {scratch.data() + program.size(), program.size()})};
}

void values(const Program& program, std::span<const glm::dvec3> points, std::span<double> values) {
    points_in_parts(program, points.size(), kLanes, [&](std::size_t begin, std::size_t end) {
        std::vector<Lanes> scratch(program.size());
        for (; begin < end; begin += kLanes) {
            forward<Lanes>(program, gathered(points, begin), scratch);
            for (std::size_t k = 0; k < std::min(kLanes, end - begin); ++k)
                values[begin + k] = real_or_nan(scratch.back().v[k]);
        }
    });
}

void samples(const Program& program, std::span<const glm::dvec3> points, std::span<Sample> samples) {
    points_in_parts(program, points.size(), kLanes, [&](std::size_t begin, std::size_t end) {
        std::vector<Lanes> scratch(2 * program.size());
        const std::span<Lanes> v(scratch.data(), program.size()), d(scratch.data() + program.size(), program.size());
        for (; begin < end; begin += kLanes) {
            forward<Lanes>(program, gathered(points, begin), v);
            const std::array<Lanes, 3> g = reverse<Lanes>(program, v, d);
            for (std::size_t k = 0; k < std::min(kLanes, end - begin); ++k)
                samples[begin + k] = {real_or_nan(v.back().v[k]), {g[0].v[k], g[1].v[k], g[2].v[k]}};
        }
    });
}

}  // namespace normalscope::formulas

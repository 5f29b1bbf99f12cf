#include "core/program/single.h"

#include "core/program/points_in_parts.h"
#include "core/program/steps.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace normalscope::formulas {

namespace {

struct Single {
    double v = 0.0;  // one that a float holds

    Single() = default;
    explicit Single(double value)
        : v(std::abs(value) < double{std::numeric_limits<float>::min()} ? 0.0 : double{static_cast<float>(value)}) {}
};

Single operator+(Single a, Single b) { return Single(a.v + b.v); }
Single operator-(Single a, Single b) { return Single(a.v - b.v); }
Single operator-(Single a) { return Single(-a.v); }
Single operator*(Single a, Single b) { return Single(a.v * b.v); }
Single operator/(Single a, Single b) { return Single(a.v / b.v); }
Single power(Single a, double exponent, Parity parity) { return Single(real::power(a.v, exponent, parity)); }
Single power(Single a, Single b) { return Single(real::power(a.v, b.v)); }
Single exp(Single a) { return Single(std::max(std::exp(a.v), double{std::numeric_limits<float>::min()})); }
Single sqrt(Single a) { return Single(std::sqrt(a.v)); }
Single log(Single a) { return Single(real::log(a.v)); }
Single sin(Single a) { return Single(std::sin(a.v)); }
Single cos(Single a) { return Single(std::cos(a.v)); }
Single tan(Single a) { return Single(std::tan(a.v)); }
Single asin(Single a) { return Single(std::asin(a.v)); }
Single acos(Single a) { return Single(std::acos(a.v)); }
Single atan(Single a) { return Single(std::atan(a.v)); }
Single sinh(Single a) { return Single(std::sinh(a.v)); }
Single cosh(Single a) { return Single(std::cosh(a.v)); }
Single tanh(Single a) { return Single(std::tanh(a.v)); }
Single asinh(Single a) { return Single(std::asinh(a.v)); }
Single acosh(Single a) { return Single(std::acosh(a.v)); }
Single atanh(Single a) { return Single(std::atanh(a.v)); }
Single atan2(Single a, Single b) { return Single(real::atan2(a.v, b.v)); }
Single abs(Single a) { return Single(std::abs(a.v)); }
Single sign(Single a) { return Single(real::sign(a.v)); }
Single floor(Single a) { return Single(std::floor(a.v)); }
Single min(Single a, Single b) { return Single(real::min(a.v, b.v)); }
Single max(Single a, Single b) { return Single(real::max(a.v, b.v)); }
Single where(Single a, Single c, Single b) { return Single(real::where(a.v, c.v, b.v)); }

}  // namespace

void values_in_floats(const Program& program, std::span<const glm::dvec3> points, std::span<double> values) {
    points_in_parts(program, points.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<Single> steps(program.size());
        for (std::size_t i = begin; i < end; ++i) {
            forward<Single>(program, {Single(points[i].x), Single(points[i].y), Single(points[i].z)}, steps);
            values[i] = steps.back().v;
        }
    });
}

}  // namespace normalscope::formulas

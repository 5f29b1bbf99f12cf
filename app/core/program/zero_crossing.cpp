#include "core/program/zero_crossing.h"

#include "core/program/evaluate.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace normalscope::formulas {

namespace {

constexpr int kMostHalvings = 64;

// What rounding alone may make of 0 there.
bool as_good_as_zero(const Program& program, const glm::dvec3& p) {
    const Interval v = value(program, Box{p, p});
    return v.defined == Interval::Defined::Everywhere && std::isfinite(v.width()) && v.low <= 4.0 * v.width() &&
           v.high >= -4.0 * v.width();
}

bool continuous(const Program& program, const glm::dvec3& a, const glm::dvec3& b) {
    const Interval v = value(program, Box{glm::min(a, b), glm::max(a, b)});
    return v.defined == Interval::Defined::Everywhere && std::isfinite(v.width());
}

}  // namespace

bool may_jump(const Program& program) {
    return std::ranges::any_of(program, [&](const Instruction& i) {
        if (!i.varies) return false;
        switch (i.code) {
            case Code::Divide: return program[i.b].varies;
            case Code::IntegerPower:
            case Code::RealPower: return i.constant < 0.0;
            case Code::Power:
            case Code::Tan:
            case Code::Sign:
            case Code::Floor:
            case Code::Atan2:
            case Code::Where: return true;
            default: return false;
        }
    });
}

std::optional<double> zero_between(const Program& program, const glm::dvec3& a, const glm::dvec3& b) {
    const auto at = [&](double s) { return glm::mix(a, b, s); };
    const auto f = [&](double s) { return value(program, at(s)); };
    double low = 0.0, high = 1.0, f_low = f(low), f_high = f(high);
    const bool falling = f_high < 0.0;
    std::vector<double> sizes;
    for (int i = 0; i < kMostHalvings; ++i) {
        sizes.push_back(std::max(std::abs(f_low), std::abs(f_high)));
        double s = 0.5 * (low + high);
        if (at(s) == at(low) || at(s) == at(high)) break;
        double v = f(s);
        if (std::isnan(v)) v = f(s = low + 0.4142 * (high - low));  // a pole was met by chance
        if (std::isnan(v)) return std::nullopt;                     // a gap
        ((v < 0.0) == falling ? high : low) = s;
        ((v < 0.0) == falling ? f_high : f_low) = v;
    }
    // At a zero |f| becomes smaller and smaller on both sides, be it as slowly as a ninth root. At a pole it grows, at a
    // jump it stays.
    const bool shrinks = sizes.back() <= 0.5 * sizes[sizes.size() / 2];
    const auto rounds = [&] { return as_good_as_zero(program, at(low)) && as_good_as_zero(program, at(high)); };
    if (shrinks || continuous(program, a, b) || rounds()) return 0.5 * (low + high);
    return std::nullopt;
}

}  // namespace normalscope::formulas

#pragma once

// What each step of a program computes, and its derivatives: written once for doubles, for many doubles side by side
// and for intervals.

#include "core/program/interval.h"
#include "core/program/program.h"
#include "core/program/waves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace normalscope::formulas {

namespace real {
inline double log(double v) { return v > 0.0 ? std::log(v) : kNaN; }
inline double sin(double v) { return sines(std::array{v}, 0)[0]; }
inline double cos(double v) { return sines(std::array{v}, 1)[0]; }
inline double tan(double v) { return std::tan(v); }
inline double asin(double v) { return std::asin(v); }
inline double acos(double v) { return std::acos(v); }
inline double atan(double v) { return std::atan(v); }
inline double sinh(double v) { return std::sinh(v); }
inline double cosh(double v) { return std::cosh(v); }
inline double tanh(double v) { return std::tanh(v); }
inline double asinh(double v) { return std::asinh(v); }
inline double acosh(double v) { return std::acosh(v); }
inline double atanh(double v) { return std::atanh(v); }
inline double abs(double v) { return std::abs(v); }
inline double floor(double v) { return std::floor(v); }
inline double sqrt(double v) { return std::sqrt(v); }
inline double min(double a, double b) { return a <= b || std::isnan(a) ? a : b; }
inline double max(double a, double b) { return a >= b || std::isnan(a) ? a : b; }
inline double where(double a, double c, double b) { return std::isnan(c) ? c : c <= 0.0 ? a : b; }
// At a kink the derivative is either side's, or any between: intervals tell that from a jump.
inline double slope_of_abs(double v) { return sign(v); }
inline double slope_where(double a, double c, double b) { return where(a, c, b); }
}  // namespace real

inline Interval sqrt(const Interval& a) { return power(a, 0.5, Parity::None); }

/// The result of one step.
template <class T>
T result(const Instruction& i, const T& a, const T& b, const T& c) {
    using namespace real;  // for T = double; other types bring their own
    switch (i.code) {
        case Code::Add: return a + b;
        case Code::Subtract: return a - b;
        case Code::Multiply: return a * b;
        case Code::Divide: return a / b;
        case Code::Negate: return -a;
        case Code::IntegerPower:
        case Code::RealPower: return power(a, i.constant, i.parity);
        case Code::Power: return power(a, b);
        case Code::Exp: return exp(a);
        case Code::Sqrt: return sqrt(a);
        case Code::Log: return log(a);
        case Code::Sin: return sin(a);
        case Code::Cos: return cos(a);
        case Code::Tan: return tan(a);
        case Code::Asin: return asin(a);
        case Code::Acos: return acos(a);
        case Code::Atan: return atan(a);
        case Code::Sinh: return sinh(a);
        case Code::Cosh: return cosh(a);
        case Code::Tanh: return tanh(a);
        case Code::Asinh: return asinh(a);
        case Code::Acosh: return acosh(a);
        case Code::Atanh: return atanh(a);
        case Code::Abs: return abs(a);
        case Code::Sign: return sign(a);
        case Code::Floor: return floor(a);
        case Code::Min: return min(a, b);
        case Code::Max: return max(a, b);
        case Code::Atan2: return atan2(a, b);
        case Code::Where: return where(a, b, c);
        default: return T(i.constant);
    }
}

/// Runs the program on (x, y, z); values[k] is what step k gives.
template <class T>
void forward(const Program& program, const std::array<T, 3>& at, std::span<T> values) {
    for (std::size_t k = 0; k < program.size(); ++k) {
        const Instruction& i = program[k];
        values[k] = i.code == Code::Variable ? at[i.a] : result(i, values[i.a], values[i.b], values[i.c]);
    }
}

/// Which steps the value is made of: −1 for those that count, 1 for those that only stand in what where, min or max did not
/// take; both, for intervals, where it depends. Empty where all count.
template <class T>
std::vector<T> taken_steps(const Program& program, std::span<const T> values) {
    using namespace real;
    const auto chooses = [](const Instruction& i) {
        return i.varies && (i.code == Code::Where || i.code == Code::Min || i.code == Code::Max);
    };
    if (std::none_of(program.begin(), program.end(), chooses)) return {};
    const T counts(-1.0), left_out(1.0);
    std::vector<T> taken(program.size(), left_out);
    const auto take = [&](std::uint32_t step, const T& from) { taken[step] = min(taken[step], from); };
    taken.back() = counts;
    for (std::size_t k = program.size(); k-- > 0;) {
        const Instruction& i = program[k];
        const T from = taken[k];
        const auto choose = [&](std::uint32_t first, const T& condition, std::uint32_t second) {
            take(first, slope_where(slope_where(from, condition, left_out), from, left_out));
            take(second, slope_where(slope_where(left_out, condition, from), from, left_out));
        };
        const T &a = values[i.a], &b = values[i.b];
        switch (i.code) {
            case Code::Where:
                take(i.b, from);
                choose(i.a, b, i.c);
                break;
            case Code::Min: choose(i.a, a - b, i.b); break;
            case Code::Max: choose(i.a, b - a, i.b); break;
            default:
                if (operands(i.code) > 0) take(i.a, from);
                if (operands(i.code) > 1) take(i.b, from);
        }
    }
    return taken;
}

/// ∂value/∂(x, y, z) by reverse accumulation: from the last step back, every step hands its derivative on to its
/// operands, so that the whole gradient costs a few times the value, however many variables there are. (Griewank and
/// Walther, "Evaluating Derivatives", chapter 3.) `values` as forward() left them, `d` as many. What where, min or max did
/// not take has no part in it, even where it has no derivative, or no value.
template <class T>
std::array<T, 3> reverse(const Program& program, std::span<const T> values, std::span<T> d) {
    using namespace real;
    const T zero(0.0), one(1.0);
    std::array<T, 3> gradient{zero, zero, zero};
    const std::vector<T> taken = taken_steps(program, values);
    for (T& v : d) v = zero;
    d[program.size() - 1] = one;
    for (std::size_t k = program.size(); k-- > 0;) {
        const Instruction& i = program[k];
        if (!i.varies) continue;
        const T w = d[k];
        if (i.code == Code::Variable) {
            gradient[i.a] += w;
            continue;
        }
        const T &a = values[i.a], &b = values[i.b];
        std::array<T, 3> before;  // of use where some steps are left out alone: this is a hot loop
        if (!taken.empty()) before = {d[i.a], d[i.b], d[i.c]};
        const bool left = program[i.a].varies, right = program[i.b].varies;
        switch (i.code) {
            case Code::Add:
                if (left) d[i.a] += w;
                if (right) d[i.b] += w;
                break;
            case Code::Subtract:
                if (left) d[i.a] += w;
                if (right) d[i.b] += -w;
                break;
            case Code::Multiply:
                if (left) d[i.a] += w * b;
                if (right) d[i.b] += w * a;
                break;
            case Code::Divide: {
                const T part = w / b;
                if (left) d[i.a] += part;
                if (right) d[i.b] += -(part * values[k]);
                break;
            }
            case Code::Negate: d[i.a] += -w; break;
            case Code::IntegerPower:
            case Code::RealPower: d[i.a] += w * (T(i.constant) * power(a, i.constant - 1.0, flipped(i.parity))); break;
            case Code::Power:
                if (left) d[i.a] += w * (b * power(a, b - one));
                if (right) d[i.b] += w * (values[k] * log(a));
                break;
            case Code::Exp: d[i.a] += w * values[k]; break;
            case Code::Sqrt: d[i.a] += w * (T(0.5) / values[k]); break;
            case Code::Log: d[i.a] += w / a; break;
            case Code::Sin: d[i.a] += w * cos(a); break;
            case Code::Cos: d[i.a] += -(w * sin(a)); break;
            case Code::Tan: d[i.a] += w * (one + power(values[k], 2.0, Parity::Even)); break;
            case Code::Asin: d[i.a] += w / sqrt(one - power(a, 2.0, Parity::Even)); break;
            case Code::Acos: d[i.a] += -(w / sqrt(one - power(a, 2.0, Parity::Even))); break;
            case Code::Atan: d[i.a] += w / (one + power(a, 2.0, Parity::Even)); break;
            case Code::Sinh: d[i.a] += w * cosh(a); break;
            case Code::Cosh: d[i.a] += w * sinh(a); break;
            case Code::Tanh: d[i.a] += w * power(cosh(a), -2.0, Parity::Even); break;
            case Code::Asinh: d[i.a] += w / sqrt(power(a, 2.0, Parity::Even) + one); break;
            case Code::Acosh: d[i.a] += w / sqrt(power(a, 2.0, Parity::Even) - one); break;
            case Code::Atanh: d[i.a] += w / (one - power(a, 2.0, Parity::Even)); break;
            case Code::Abs: d[i.a] += w * slope_of_abs(a); break;
            case Code::Min:
                if (left) d[i.a] += slope_where(w, a - b, zero);
                if (right) d[i.b] += slope_where(zero, a - b, w);
                break;
            case Code::Max:
                if (left) d[i.a] += slope_where(w, b - a, zero);
                if (right) d[i.b] += slope_where(zero, b - a, w);
                break;
            case Code::Atan2: {
                const T part = w / (power(a, 2.0, Parity::Even) + power(b, 2.0, Parity::Even));
                if (left) d[i.a] += part * b;
                if (right) d[i.b] += -(part * a);
                break;
            }
            case Code::Where:
                if (left) d[i.a] += slope_where(w, b, zero);
                if (program[i.c].varies) d[i.c] += slope_where(zero, b, w);
                break;
            default: break;
        }
        if (taken.empty()) continue;
        d[i.a] = slope_where(d[i.a], taken[k], before[0]);
        d[i.b] = slope_where(d[i.b], taken[k], before[1]);
        d[i.c] = slope_where(d[i.c], taken[k], before[2]);
    }
    return gradient;
}

}  // namespace normalscope::formulas

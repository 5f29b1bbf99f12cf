#include "core/program/glsl.h"

#include "core/formula/formula.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace normalscope::formulas {

namespace {

constexpr double kMostFactors = 16.0;  // longer powers are left to pow()

std::string literal(double v, Precision precision) {
    const bool twice = precision == Precision::Double;
    const double most = twice ? 1e300 : 3e38;
    v = std::clamp(std::isnan(v) ? 0.0 : v, -most, most);
    char text[40];
    char* const end = twice ? std::to_chars(text, text + sizeof text, v).ptr
                            : std::to_chars(text, text + sizeof text, static_cast<float>(v)).ptr;
    const std::string s(text, end);
    const std::string real = (s.find_first_of(".e") == std::string::npos ? s + ".0" : s) + (twice ? "lf" : "");
    return v < 0.0 ? "(" + real + ")" : real;
}

class Generator {
public:
    Generator(const Program& program, Precision precision) : program_(program), precision_(precision) {}

    Glsl run() {
        Glsl result;
        names_.resize(program_.size());
        for (std::uint32_t k = 0; k < program_.size(); ++k) names_[k] = forward(k);
        const std::string forward_body = body_;
        const std::string value = names_.back();

        adjoints_.resize(program_.size());
        const std::string gradient = reverse();
        const std::string gradient_body = body_;

        body_.clear();
        defined_.resize(program_.size());
        for (std::uint32_t k = 0; k < program_.size(); ++k) defined_[k] = defined(k);
        const std::string defined = defined_.back();
        result.defined_everywhere = defined.empty();
        result.source = uniforms_ + "REAL f(REAL3 p) {\n" + forward_body + "    return " + value + ";\n}\n" +
                        "REAL3 gradient(REAL3 p) {\n" + gradient_body + "    return " + gradient + ";\n}\n" +
                        "bool is_defined(REAL3 p) {\n" + (defined.empty() ? "" : forward_body + body_) + "    return " +
                        (defined.empty() ? "true" : defined) + ";\n}\n";
        return result;
    }

private:
    std::string number(double v) const { return literal(v, precision_); }

    std::string temporary(const std::string& expression) {
        const std::string name = "t" + std::to_string(temporaries_++);
        body_ += "    REAL " + name + " = " + expression + ";\n";
        return name;
    }

    // base^n as products of squares, each named once.
    std::string integer_power(std::string base, double exponent, Parity parity) {
        const double n = std::abs(exponent);
        if (exponent < 0.0) return "1.0 / nonzero(" + integer_power(base, n, parity) + ")";
        if (n == 0.0) return "1.0";
        if (n > kMostFactors)
            return (parity == Parity::Odd ? "odd_pow(" : "safe_pow(abs(") + base +
                   (parity == Parity::Odd ? ", " : "), ") + number(n) + ")";
        std::string product;
        for (auto bits = static_cast<unsigned>(n); bits != 0; bits >>= 1) {
            if (bits & 1) product = product.empty() ? base : product + " * " + base;
            if (bits > 3)
                base = temporary(base + " * " + base);
            else if (bits > 1)
                base = bits == 2 && product.empty() ? base + " * " + base : temporary(base + " * " + base);
        }
        return product;
    }

    std::string real_power(const std::string& base, double exponent, Parity parity) {
        if (parity == Parity::Even) return "safe_pow(abs(" + base + "), " + number(exponent) + ")";
        return (parity == Parity::Odd ? "odd_pow(" : "safe_pow(") + base + ", " + number(exponent) + ")";
    }

    std::string forward(std::uint32_t k) {
        const Instruction& i = program_[k];
        const std::string a = operands(i.code) > 0 ? names_[i.a] : "", b = operands(i.code) > 1 ? names_[i.b] : "";
        const auto call = [&](const char* name) { return temporary(std::string(name) + "(" + a + ")"); };
        switch (i.code) {
            case Code::Constant: return number(i.constant);
            case Code::Parameter: {
                const std::string name =
                    std::string("formula_") + kParameterNames[static_cast<std::size_t>(i.constant)];
                uniforms_ += "uniform float " + name + ";\n";
                return name;
            }
            case Code::Variable: return std::string("p.") + kVariableNames[i.a];
            case Code::Add: return temporary(a + " + " + b);
            case Code::Subtract: return temporary(a + " - " + b);
            case Code::Multiply: return temporary(a + " * " + b);
            case Code::Divide: return temporary(a + " / nonzero(" + b + ")");
            case Code::Negate: return temporary("-" + a);
            case Code::IntegerPower: return temporary(integer_power(a, i.constant, i.parity));
            case Code::RealPower: return temporary(real_power(a, i.constant, i.parity));
            case Code::Power: return temporary("any_pow(" + a + ", " + b + ")");
            case Code::Exp: return call("safe_exp");
            case Code::Sqrt: return temporary("sqrt(max(" + a + ", 0.0))");
            case Code::Log: return temporary("log(max(" + a + ", TINY))");
            case Code::Sin: return call("wave_sin");
            case Code::Cos: return call("wave_cos");
            case Code::Tan: return call("tan");
            case Code::Asin: return temporary("atan(" + a + ", leg(" + a + "))");
            case Code::Acos: return temporary("atan(leg(" + a + "), " + a + ")");
            case Code::Atan: return call("atan");
            case Code::Sinh: return call("sinh_of");
            case Code::Cosh: return call("cosh_of");
            case Code::Tanh: return call("tanh_of");
            case Code::Asinh: return temporary("sign(" + a + ") * area_of(abs(" + a + "), REAL(1.0))");
            case Code::Acosh: return temporary("area_of(max(" + a + ", 1.0), REAL(-1.0))");
            case Code::Atanh: return temporary("0.5 * log(max((1.0 + " + a + ") / nonzero(1.0 - " + a + "), TINY))");
            case Code::Abs: return call("abs");
            case Code::Sign: return call("sign");
            case Code::Floor: return call("floor");
            case Code::Min: return temporary("min(" + a + ", " + b + ")");
            case Code::Max: return temporary("max(" + a + ", " + b + ")");
            case Code::Atan2: return temporary("angle_of(" + a + ", " + b + ")");
            case Code::Where: return temporary(b + " <= 0.0 ? " + a + " : " + names_[i.c]);
        }
        return {};
    }

    // What must hold for this step to have a real value; empty where it always has.
    std::string condition(std::uint32_t k) const {
        const Instruction& i = program_[k];
        const std::string a = operands(i.code) > 0 ? names_[i.a] : "", b = operands(i.code) > 1 ? names_[i.b] : "";
        const bool constant_divisor =
            i.code == Code::Divide && program_[i.b].code == Code::Constant && program_[i.b].constant != 0.0;
        switch (i.code) {
            case Code::Constant: return std::isfinite(i.constant) ? "" : "false";
            case Code::Divide: return constant_divisor ? "" : b + " != 0.0";
            case Code::IntegerPower: return i.constant < 0.0 ? a + " != 0.0" : "";
            case Code::RealPower:
                if (i.parity != Parity::None) return i.constant < 0.0 ? a + " != 0.0" : "";
                return a + (i.constant < 0.0 ? " > 0.0" : " >= 0.0");
            case Code::Power:
                return "(" + a + " > 0.0 || (" + a + " == 0.0 ? " + b + " > 0.0 : " + b + " == floor(" + b + ")))";
            case Code::Sqrt: return a + " >= 0.0";
            case Code::Log: return a + " > 0.0";
            case Code::Atan2: return "(" + a + " != 0.0 || " + b + " != 0.0)";
            case Code::Asin:
            case Code::Acos: return "abs(" + a + ") <= 1.0";
            case Code::Acosh: return a + " >= 1.0";
            case Code::Atanh: return "abs(" + a + ") < 1.0";
            default: return {};
        }
    }

    // Whether the step has a real value, as a name of what has been computed; empty where it always has. What `where` does not
    // take need not have any.
    std::string defined(std::uint32_t k) {
        const Instruction& i = program_[k];
        const int count = operands(i.code);
        std::vector<std::string> all;
        const auto demand = [&](const std::string& c) {
            if (!c.empty() && std::ranges::count(all, c) == 0) all.push_back(c);
        };
        demand(condition(k));
        if (i.code == Code::Where) {
            const std::string &first = defined_[i.a], &second = defined_[i.c];
            const auto or_always = [](const std::string& c) { return c.empty() ? "true" : c; };
            demand(defined_[i.b]);
            if (first == second)
                demand(first);
            else
                demand("(" + names_[i.b] + " <= 0.0 ? " + or_always(first) + " : " + or_always(second) + ")");
        } else {
            if (count > 0) demand(defined_[i.a]);
            if (count > 1) demand(defined_[i.b]);
        }
        if (all.size() < 2 && condition(k).empty() && i.code != Code::Where) return all.empty() ? "" : all.front();
        if (all.empty()) return {};
        const std::string name = "d" + std::to_string(k);
        body_ += "    bool " + name + " = ";
        for (const std::string& c : all) body_ += (&c == &all.front() ? "" : " && ") + c;
        body_ += ";\n";
        return name;
    }

    void contribute(std::uint32_t step, const std::string& term) {
        if (!program_[step].varies) return;
        std::string& sum = adjoints_[step];
        sum += (sum.empty() ? "" : " + ") + term;
    }
    // factor · w, where w may be 1.
    static std::string times(const std::string& w, const std::string& factor) {
        return w == "1.0" ? factor : factor == "1.0" ? w : w + " * " + factor;
    }

    std::string reverse() {
        std::array<std::string, 3> gradient{"0.0", "0.0", "0.0"};
        if (program_.back().varies) adjoints_.back() = "1.0";
        for (auto k = static_cast<std::uint32_t>(program_.size()); k-- > 0;) {
            const Instruction& i = program_[k];
            if (!i.varies || adjoints_[k].empty()) continue;
            const bool simple = adjoints_[k].find_first_of(" (") == std::string::npos;
            const std::string w = simple ? adjoints_[k] : temporary(adjoints_[k]);
            if (i.code == Code::Variable)
                gradient[i.a] = w;
            else
                hand_on(i, names_[k], w);
        }
        return "REAL3(" + gradient[0] + ", " + gradient[1] + ", " + gradient[2] + ")";
    }

    void hand_on(const Instruction& i, const std::string& value, const std::string& w) {
        const std::string a = names_[i.a], b = operands(i.code) > 1 ? names_[i.b] : "";
        const auto minus = [](const std::string& v) { return "(-" + v + ")"; };
        const auto choose = [&](const std::string& condition, bool when) {
            return "(" + condition + " ? " + (when ? w + " : 0.0)" : "0.0 : " + w + ")");
        };
        switch (i.code) {
            case Code::Add:
                contribute(i.a, w);
                contribute(i.b, w);
                break;
            case Code::Subtract:
                contribute(i.a, w);
                contribute(i.b, minus(w));
                break;
            case Code::Multiply:
                contribute(i.a, times(w, b));
                contribute(i.b, times(w, a));
                break;
            case Code::Divide: {
                const std::string part = temporary(w + " / nonzero(" + b + ")");
                contribute(i.a, part);
                contribute(i.b, minus(part + " * " + value));
                break;
            }
            case Code::Negate: contribute(i.a, minus(w)); break;
            case Code::IntegerPower:
            case Code::RealPower: {
                const bool whole = i.code == Code::IntegerPower;
                const std::string power = whole ? integer_power(a, i.constant - 1.0, flipped(i.parity))
                                                : real_power(a, i.constant - 1.0, flipped(i.parity));
                contribute(i.a, times(w, number(i.constant) + " * " + power));
                break;
            }
            case Code::Power:
                if (program_[i.a].varies) contribute(i.a, times(w, b + " * any_pow(" + a + ", " + b + " - 1.0)"));
                if (program_[i.b].varies) contribute(i.b, times(w, value + " * log(max(" + a + ", TINY))"));
                break;
            case Code::Exp: contribute(i.a, times(w, value)); break;
            case Code::Sqrt: contribute(i.a, w + " * 0.5 / max(" + value + ", ROOT_OF_TINY)"); break;
            case Code::Log: contribute(i.a, w + " / max(" + a + ", TINY)"); break;
            case Code::Sin: contribute(i.a, times(w, "wave_cos(" + a + ")")); break;
            case Code::Cos: contribute(i.a, minus(times(w, "wave_sin(" + a + ")"))); break;
            case Code::Tan: contribute(i.a, times(w, "(1.0 + " + value + " * " + value + ")")); break;
            case Code::Asin: contribute(i.a, w + " / sqrt(max(1.0 - " + a + " * " + a + ", TINY))"); break;
            case Code::Acos: contribute(i.a, minus(w + " / sqrt(max(1.0 - " + a + " * " + a + ", TINY))")); break;
            case Code::Atan: contribute(i.a, w + " / (1.0 + " + a + " * " + a + ")"); break;
            case Code::Sinh: contribute(i.a, times(w, "cosh_of(" + a + ")")); break;
            case Code::Cosh: contribute(i.a, times(w, "sinh_of(" + a + ")")); break;
            case Code::Tanh: {
                const std::string sech = temporary("sech_of(" + a + ")");
                contribute(i.a, times(w, sech + " * " + sech));
                break;
            }
            case Code::Asinh: contribute(i.a, times(w, "area_slope(abs(" + a + "), REAL(1.0))")); break;
            case Code::Acosh: contribute(i.a, times(w, "area_slope(" + a + ", REAL(-1.0))")); break;
            case Code::Atanh: contribute(i.a, w + " / nonzero(1.0 - " + a + " * " + a + ")"); break;
            case Code::Abs: contribute(i.a, times(w, "sign(" + a + ")")); break;
            case Code::Min:
            case Code::Max: {
                const std::string first = a + (i.code == Code::Min ? " <= " : " >= ") + b;
                contribute(i.a, choose(first, true));
                contribute(i.b, choose(first, false));
                break;
            }
            case Code::Atan2: {
                const std::string part = temporary(w + " / max(" + a + " * " + a + " + " + b + " * " + b + ", TINY)");
                contribute(i.a, part + " * " + b);
                contribute(i.b, minus(part + " * " + a));
                break;
            }
            case Code::Where:
                contribute(i.a, choose(b + " <= 0.0", true));
                contribute(i.c, choose(b + " <= 0.0", false));
                break;
            default: break;
        }
    }

    const Program& program_;
    Precision precision_;
    std::string uniforms_, body_;
    int temporaries_ = 0;
    std::vector<std::string> names_, adjoints_, defined_;
};

}  // namespace

Glsl to_glsl(const Program& program, Precision precision) { return Generator(program, precision).run(); }

}  // namespace normalscope::formulas

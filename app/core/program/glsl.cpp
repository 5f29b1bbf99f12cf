#include "core/program/glsl.h"

#include "core/formula/formula.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ranges>

namespace normalscope::formulas {

namespace {

// Of either kind: its names, how near to 0 and how large a number may be, and for doubles what double.glsl defines.
constexpr std::string_view kSingle =
    "#define REAL float\n#define REAL2 vec2\n#define REAL3 vec3\n#define DOUBLE false\n"
    "#define TINY 1e-30\n#define ROOT_OF_TINY 1e-15\n#define HUGE 1e30\n#define MOST_EXPONENT 69.0\n#define LEAST "
    "1.2e-38\n"
    "#define LARGEST 3e37\n";
constexpr std::string_view kDouble =
    "#define DOUBLES\n#define REAL double\n#define REAL2 dvec2\n#define REAL3 dvec3\n#define DOUBLE true\n"
    "#define TINY 1e-290lf\n#define ROOT_OF_TINY 1e-145lf\n#define HUGE 1e290lf\n#define MOST_EXPONENT "
    "660.0lf\n#define LEAST 2.3e-308lf\n"
    "#define LARGEST 1e300lf\n"
    "double exp(double x);\ndouble log(double x);\ndouble pow(double b, double e);\ndouble sin(double x);\n"
    "double cos(double x);\ndouble tan(double x);\n"
    "double atan(double x);\ndouble atan(double y, double x);\n";

// sin(x − kπ) for k near x/π: to 24 bits or nearly so, as drivers' own sines are, in half the steps, since all rays of a picture
// spend their time here. π is in two parts. The polynomial has the least largest error on [−π/2, π/2].
constexpr std::string_view kHalfTurns =
    "float half_turns(float x, float k) {\n"
    "    float r = (x - k * 3.140625) - k * 9.67653589793e-4, q = r * r;\n"
    "    return r + r * q * (-0.166666597 + q * (0.00833306648 + q * (-1.98095950e-4 + q * 2.60576166e-6)));\n"
    "}\n";

// What GLSL has not, or leaves undefined outside a domain: there these give something finite, and is_defined says no.
// One may use those before it.
struct Helper {
    std::string_view name, source;
};
constexpr std::array kHelpers{
    Helper{"half_turns", kHalfTurns},
    Helper{"wave_sin",
           "float wave_sin(float x) {\n"
           "    float k = floor(x * 0.318309886 + 0.5), s = half_turns(x, k);\n"
           "    return fract(0.5 * k) > 0.25 ? -s : s;\n"
           "}\n"},
    Helper{"wave_cos",
           "float wave_cos(float x) {\n"
           "    float k = floor(x * 0.318309886) + 0.5, s = half_turns(x, k);\n"
           "    return fract(0.5 * k) < 0.5 ? -s : s;\n"
           "}\n"},
    Helper{"nonzero", "REAL nonzero(REAL v) { return abs(v) > TINY ? v : v < 0.0 ? -TINY : TINY; }\n"},
    Helper{"safe_pow", "REAL safe_pow(REAL b, REAL e) { return min(pow(max(b, TINY), e), HUGE); }\n"},
    Helper{"odd_pow", "REAL odd_pow(REAL b, REAL e) { return sign(b) * min(pow(max(abs(b), TINY), e), HUGE); }\n"},
    Helper{"any_pow",
           "REAL any_pow(REAL b, REAL e) {\n"
           "    REAL s = min(pow(max(abs(b), TINY), e), HUGE);\n"
           "    return b < 0.0 && mod(e, 2.0) == 1.0 ? -s : s;\n"
           "}\n"},
    Helper{"angle_of", "REAL angle_of(REAL y, REAL x) { return x == 0.0 && y == 0.0 ? REAL(0.0) : atan(y, x); }\n"},
    // √(1 − v²): drivers' own arcsines are right to four digits only.
    Helper{"leg", "REAL leg(REAL v) { return sqrt(max((1.0 - v) * (1.0 + v), 0.0)); }\n"},
    Helper{"safe_exp", "REAL safe_exp(REAL v) { return max(exp(min(v, MOST_EXPONENT)), LEAST); }\n"},
    Helper{"sinh_of", "REAL sinh_of(REAL v) { return 0.5 * (safe_exp(v) - safe_exp(-v)); }\n"},
    Helper{"cosh_of", "REAL cosh_of(REAL v) { return 0.5 * (safe_exp(v) + safe_exp(-v)); }\n"},
    Helper{"tanh_of",
           "REAL tanh_of(REAL v) {\n"
           "    REAL e = safe_exp(-2.0 * abs(v));\n"
           "    return sign(v) * (1.0 - e) / (1.0 + e);\n"
           "}\n"},
    Helper{"sech_of",
           "REAL sech_of(REAL v) {\n"
           "    REAL e = safe_exp(-abs(v));\n"
           "    return 2.0 * e / (1.0 + e * e);\n"
           "}\n"},
    // arsinh and arcosh, and their slope. Beyond 10⁸ the 1 is lost in the square, which may be too large for a number.
    Helper{
        "area_of",
        "REAL area_of(REAL v, REAL one) { return v > 1e8 ? log(v) + log(REAL(2.0)) : log(v + sqrt(v * v + one)); }\n"},
    Helper{"area_slope",
           "REAL area_slope(REAL v, REAL one) {\n"
           "    return v > 1e8 ? 1.0 / v : 1.0 / sqrt(max(v * v + one, TINY));\n"
           "}\n"},
};

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
        std::string helpers;
        for (const Helper& h : kHelpers | std::views::reverse)
            if ((helpers + gradient_body + gradient + value).find(h.name) != std::string::npos)
                helpers.insert(0, h.source);
        result.source = std::string(precision_ == Precision::Double ? kDouble : kSingle) + uniforms_ + helpers +
                        "REAL f(REAL3 p) {\n" + forward_body + "    return " + value + ";\n}\n" +
                        "REAL3 gradient(REAL3 p) {\n" + gradient_body + "    return " + gradient + ";\n}\n" +
                        "bool is_defined(REAL3 p) {\n" + (defined.empty() ? "" : forward_body + body_) + "    return " +
                        (defined.empty() ? "true" : defined) + ";\n}\n";
        return result;
    }

private:
    std::string number(double v) const { return literal(v, precision_); }
    std::string wave(const char* name, const std::string& a) const {
        return std::string(precision_ == Precision::Double ? "" : "wave_") + name + "(" + a + ")";
    }

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
            case Code::Sin: return temporary(wave("sin", a));
            case Code::Cos: return temporary(wave("cos", a));
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
            case Code::Sin: contribute(i.a, times(w, wave("cos", a))); break;
            case Code::Cos: contribute(i.a, minus(times(w, wave("sin", a)))); break;
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

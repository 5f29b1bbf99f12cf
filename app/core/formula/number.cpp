#include "core/formula/number.h"

#include "core/base/decimal.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace normalscope::formulas {

namespace {

constexpr std::int64_t kMost = std::int64_t{1} << 53;

bool fits(std::int64_t v) { return -kMost <= v && v <= kMost; }

struct Decimal {
    std::string digits;         // without leading zeros
    std::int64_t exponent = 0;  // the value is digits × 10^exponent
};

Decimal split(std::string_view text) {
    Decimal d;
    std::size_t i = 0;
    bool after_point = false;
    for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
        if (text[i] == '.') {
            after_point = true;
            continue;
        }
        if (!d.digits.empty() || text[i] != '0') d.digits += text[i];
        d.exponent -= after_point ? 1 : 0;
    }
    if (i < text.size()) {
        const bool minus = text[++i] == '-';
        if (minus || text[i] == '+') ++i;
        std::int64_t e = 0;
        for (; i < text.size(); ++i) e = std::min<std::int64_t>(10 * e + (text[i] - '0'), 1'000'000'000);
        d.exponent += minus ? -e : e;
    }
    while (!d.digits.empty() && d.digits.back() == '0') {
        d.digits.pop_back();
        ++d.exponent;
    }
    return d;
}

std::optional<Number> exactly(const Decimal& d) {
    if (d.digits.empty()) return Number(0);
    if (d.digits.size() > 16 || d.exponent < -18 || d.exponent > 18) return std::nullopt;
    std::int64_t n = 0, power = 1;
    for (const char c : d.digits) n = 10 * n + (c - '0');
    for (std::int64_t i = 0; i < std::abs(d.exponent); ++i) power *= 10;
    if (d.exponent >= 0) {
        if (__builtin_mul_overflow(n, power, &n) || !fits(n)) return std::nullopt;
        return Number(n);
    }
    const std::int64_t common = std::gcd(n, power);
    if (!fits(n / common) || !fits(power / common)) return std::nullopt;
    return Number::ratio(n, power);
}

}  // namespace

Number::Number(std::int64_t integer) : numerator_(integer), value_(static_cast<double>(integer)) {
    if (!fits(integer)) *this = from_double(value_);
}

Number Number::ratio(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t common = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
    Number n;
    n.numerator_ = numerator / common;
    n.denominator_ = denominator / common;
    n.value_ = static_cast<double>(n.numerator_) / static_cast<double>(n.denominator_);
    return fits(n.numerator_) && fits(n.denominator_) ? n : from_double(n.value_);
}

Number Number::from_double(double value) {
    if (std::isfinite(value)) {
        if (const auto n = exactly(split(shortest(std::abs(value))))) return value < 0 ? -*n : *n;
    }
    Number n;
    n.numerator_ = n.denominator_ = 0;
    n.value_ = value;
    return n;
}

Number Number::from_decimal(std::string_view text) {
    const Decimal d = split(text);
    if (const auto n = exactly(d)) return *n;
    double value = 0.0;
    read_decimal(text, value);
    return from_double(value);
}

bool Number::finite() const { return std::isfinite(value_); }
bool Number::integer() const {
    return exact() ? denominator_ == 1 : std::isfinite(value_) && std::floor(value_) == value_;
}
bool Number::even() const { return integer() && std::fmod(value_, 2.0) == 0.0; }

Number operator+(const Number& a, const Number& b) {
    if (a.exact() && b.exact()) {
        const std::int64_t common = std::gcd(a.denominator_, b.denominator_);
        std::int64_t left = 0, right = 0, sum = 0, denominator = 0;
        if (!__builtin_mul_overflow(a.numerator_, b.denominator_ / common, &left) &&
            !__builtin_mul_overflow(b.numerator_, a.denominator_ / common, &right) &&
            !__builtin_add_overflow(left, right, &sum) &&
            !__builtin_mul_overflow(a.denominator_, b.denominator_ / common, &denominator) &&
            sum != std::numeric_limits<std::int64_t>::min())
            return Number::ratio(sum, denominator);
    }
    return Number::from_double(a.value_ + b.value_);
}

Number operator*(const Number& a, const Number& b) {
    if (a.exact() && b.exact()) {
        if (a.zero() || b.zero()) return 0;
        const std::int64_t g = std::gcd(a.numerator_, b.denominator_), h = std::gcd(b.numerator_, a.denominator_);
        std::int64_t numerator = 0, denominator = 0;
        if (!__builtin_mul_overflow(a.numerator_ / g, b.numerator_ / h, &numerator) &&
            !__builtin_mul_overflow(a.denominator_ / h, b.denominator_ / g, &denominator) &&
            numerator != std::numeric_limits<std::int64_t>::min())
            return Number::ratio(numerator, denominator);
    }
    return Number::from_double(a.value_ * b.value_);
}

bool operator==(const Number& a, const Number& b) {
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_ &&
           (a.exact() || std::bit_cast<std::uint64_t>(a.value_) == std::bit_cast<std::uint64_t>(b.value_));
}

Number integer_power(const Number& base, const Number& exponent) {
    const double n = exponent.value();
    if (n == 0.0) return 1;
    if (base.exact() && base.denominator() == 1 && std::abs(base.numerator()) <= 1) {
        if (base.zero()) return n > 0 ? Number(0) : Number::from_double(std::numeric_limits<double>::quiet_NaN());
        return base.numerator() == 1 || exponent.even() ? 1 : -1;
    }
    // Any other exact number leaves the bound of 2⁵³ after at most 53 factors.
    if (!base.exact() || std::abs(n) > 53) return Number::from_double(std::pow(base.value(), n));
    Number result(1);
    for (int i = 0; i < static_cast<int>(std::abs(n)); ++i) {
        result = result * base;
        if (!result.exact()) return Number::from_double(std::pow(base.value(), n));
    }
    return n > 0 ? result : Number::ratio(result.denominator(), result.numerator());
}

std::int64_t exact_root(std::int64_t value, std::int64_t n) {
    if (value < 0 || n < 1) return -1;
    if (value <= 1 || n == 1) return value;
    const auto near = std::llround(std::pow(static_cast<double>(value), 1.0 / static_cast<double>(n)));
    if (near < 2) return -1;
    std::int64_t power = 1;
    for (std::int64_t i = 0; i < n; ++i)
        if (__builtin_mul_overflow(power, static_cast<std::int64_t>(near), &power) || power > value) return -1;
    return power == value ? near : -1;
}

std::string shortest(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string decimal(const Number& number) {
    if (!number.exact()) return shortest(number.value());
    if (number.denominator() == 1) return std::to_string(number.numerator());
    std::int64_t rest = number.denominator();
    for (const int prime : {2, 5})
        while (rest % prime == 0) rest /= prime;
    if (rest != 1 || number.denominator() < 10) return {};
    char fixed[64];
    const std::string text(fixed,
                           std::to_chars(fixed, fixed + sizeof fixed, number.value(), std::chars_format::fixed).ptr);
    // Too long a decimal does not read back as the same fraction.
    return Number::from_decimal(text.substr(number.negative() ? 1 : 0)) == (number.negative() ? -number : number)
               ? text
               : std::string();
}

}  // namespace normalscope::formulas

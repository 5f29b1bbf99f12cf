#include "core/base/decimal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <system_error>

namespace normalscope {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A decimal number's digits: `whole` · 10^`power`, where there are not more digits than fit.
struct Digits {
    std::uint64_t whole = 0;
    std::ptrdiff_t count = 0;
    std::ptrdiff_t power = 0;
};

const char* read_digits(const char* at, const char* end, Digits& digits) {
    for (; at < end && is_digit(*at); ++at, ++digits.count)
        digits.whole = 10 * digits.whole + static_cast<std::uint64_t>(*at - '0');
    return at;
}

// From the e on; the same place where no exponent stands there.
const char* read_exponent(const char* at, const char* end, std::ptrdiff_t& power) {
    constexpr std::ptrdiff_t kBeyondAll = 100'000;
    if (at == end || (*at != 'e' && *at != 'E')) return at;
    const char* digit = at + 1;
    const bool negative = digit < end && *digit == '-';
    if (digit < end && (*digit == '-' || *digit == '+')) ++digit;
    if (digit == end || !is_digit(*digit)) return at;
    std::ptrdiff_t exponent = 0;
    for (; digit < end && is_digit(*digit); ++digit) exponent = std::min(10 * exponent + (*digit - '0'), kBeyondAll);
    power += negative ? -exponent : exponent;
    return digit;
}

// What is not as simple. The C library's function is for where the standard library has none (libc++ before 20), and for
// what is out of range; no part of this program leaves the C locale's decimal point.
double rounded(std::string_view text) {
    double number = 0.0;
#ifdef __cpp_lib_to_chars
    if (std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc()) return number;
#endif
    number = std::strtod(std::string(text).c_str(), nullptr);
    return number;
}

std::string written(double number, std::chars_format format, int precision) {
    std::array<char, 400> text;  // the largest number has 309 digits before its point
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number, format, precision).ptr};
}

}  // namespace

std::size_t read_decimal(std::string_view text, double& number) {
    static constexpr std::array kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const char *const begin = text.data(), *const end = begin + text.size(), *at = begin;
    const bool negative = at < end && *at == '-';
    Digits digits;
    at = read_digits(negative ? at + 1 : at, end, digits);
    if (at < end && *at == '.') {
        const char* const point = at;
        at = read_digits(at + 1, end, digits);
        digits.power = point + 1 - at;
    }
    if (digits.count == 0) return 0;
    at = read_exponent(at, end, digits.power);
    // With so few digits that both the whole number and the power of ten are exact, so is their product or quotient, but
    // for one rounding (Clinger, "How to read floating point numbers accurately", 1990).
    constexpr std::ptrdiff_t kExact = std::ssize(kPowers) - 1;
    if (digits.count <= 15 && digits.power >= -kExact && digits.power <= kExact) {
        const double power = kPowers[static_cast<std::size_t>(std::abs(digits.power))];
        const auto whole = static_cast<double>(digits.whole);
        number = digits.power < 0 ? whole / power : whole * power;
        if (negative) number = -number;
    } else {
        number = rounded({begin, at});
    }
    return static_cast<std::size_t>(at - begin);
}

std::optional<double> decimal(std::string_view text) {
    double number = 0.0;
    return !text.empty() && read_decimal(text, number) == text.size() ? std::optional(number) : std::nullopt;
}

std::string with_decimals(double number, int decimals) { return written(number, std::chars_format::fixed, decimals); }
std::string with_digits(double number, int digits) { return written(number, std::chars_format::general, digits); }
std::string with_exponent(double number, int decimals) {
    return written(number, std::chars_format::scientific, decimals);
}

}  // namespace normalscope

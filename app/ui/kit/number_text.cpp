#include "ui/kit/number_text.h"

#include "core/base/decimal.h"

#include <cmath>

namespace normalscope {

namespace {

constexpr const char* kMinus = "\u2212";
constexpr const char* kNone = "\u2014";
constexpr double kLargestPlain = 9999.9995;  // longer ones would not fit their column

// C's text with every hyphen made a minus sign, but for a sign before nothing but zeros.
std::string typeset(const std::string& text) {
    std::string result;
    const bool nonzero = text.find_first_of("123456789") < text.find('e');
    for (const char& c : text) {
        if (c == '-')
            result += &c == text.data() && !nonzero ? "" : kMinus;
        else if (c != '+')
            result += c;
    }
    return result;
}

// "1.23e9": the exponent without its sign and leading zeros, for which a column has no room.
std::string scientific(double value) {
    std::string result = typeset(with_exponent(value, 1));
    const auto e = result.find('e');
    if (e == std::string::npos) return result;
    const auto digits = result.find_first_of("0123456789", e);
    while (digits + 1 < result.size() && result[digits] == '0') result.erase(digits, 1);
    return result;
}

}  // namespace

std::string fixed(double value, int decimals) {
    if (!std::isfinite(value)) return kNone;
    if (std::abs(value) >= kLargestPlain) return scientific(value);
    return typeset(with_decimals(value, decimals));
}

std::string fixed(const std::optional<double>& value, int decimals) { return value ? fixed(*value, decimals) : kNone; }

std::string fixed_unless_small(double value, int decimals) {
    if (value == 0.0 || !std::isfinite(value) || std::abs(value) >= 0.5 * std::pow(10.0, -decimals))
        return fixed(value, decimals);
    return scientific(value);
}

std::string in_degrees(const std::optional<double>& value, int decimals) {
    return value && std::isfinite(*value) ? fixed(*value, decimals) + "°" : kNone;
}

std::string brief(double value) {
    std::string text = fixed(value);
    if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string grouped(std::size_t count) {
    std::string text = std::to_string(count);
    for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
    return text;
}

}  // namespace normalscope

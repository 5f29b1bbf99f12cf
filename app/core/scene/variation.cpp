#include "core/scene/variation.h"

#include "core/base/decimal.h"
#include "core/base/error.h"
#include "core/base/json_path.h"
#include "core/base/json_reading.h"
#include "core/base/utf8.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostValues = 100'000;

[[noreturn]] void fail(std::string_view text, const std::string& why) {
    throw UsageError("--vary " + shortened(text, 80), why);
}

std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    for (;;) {
        const auto end = text.find(at);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

// Four rows of four numbers are the deepest value that a scene has.
bool is_of_numbers(const Json& j, int depth = 0) {
    if (j.is_number()) return std::isfinite(j.get<double>());
    if (!j.is_array() || depth == 2) return false;
    for (const Json& entry : j)
        if (!is_of_numbers(entry, depth + 1)) return false;
    return !j.empty();
}

Json end_of_range(std::string_view text, std::string_view whole) {
    try {
        if (std::optional<Json> value = read_json_or_nothing(text); value && is_of_numbers(*value)) return *value;
    } catch (const JsonError& e) {
        fail(whole, e.what());
    }
    fail(whole, "'" + shortened(text, 40) + "' is neither a number nor an array of numbers");
}

bool same_shape(const Json& a, const Json& b) {
    if (a.is_array() != b.is_array()) return false;
    if (!a.is_array()) return true;
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!same_shape(a[i], b[i])) return false;
    return true;
}

Json between(const Json& from, const Json& to, double t) {
    if (from.is_array()) {
        Json result = Json::array();
        for (std::size_t i = 0; i < from.size(); ++i) result.push_back(between(from[i], to[i], t));
        return result;
    }
    if (t == 0.0) return from;
    if (t == 1.0) return to;
    const double a = from.get<double>(), b = to.get<double>();
    // Without the digits that rounding leaves behind a decimal fraction.
    const double exact = a + t * (b - a), result = decimal(with_digits(exact, 12)).value_or(exact);
    // A whole number stays one, for keys that take no other.
    if (result == std::floor(result) && std::abs(result) < 1e15) return static_cast<std::int64_t>(result);
    return result;
}

std::size_t count_of(std::string_view text, std::string_view whole) {
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc{} || end != text.data() + text.size() || count < 1 || count > kMostValues)
        fail(whole,
             "COUNT '" + shortened(text, 20) + "' is not a whole number from 1 to " + std::to_string(kMostValues));
    return count;
}

}  // namespace

Variation parse_variation(std::string_view text, std::size_t usual_count) {
    const auto equals = text.find('=');
    const auto parts = split(equals == std::string_view::npos ? "" : text.substr(equals + 1), ':');
    if (equals == std::string_view::npos || equals == 0 || parts.size() < 2 || parts.size() > 3)
        fail(text, "expected PATH=FROM:TO or PATH=FROM:TO:COUNT, such as stack.0.scale.1=1:3:50");
    const Json from = end_of_range(parts[0], text), to = end_of_range(parts[1], text);
    if (!same_shape(from, to)) fail(text, "FROM and TO are not of one shape");
    const std::size_t count = parts.size() == 3 ? count_of(parts[2], text) : usual_count;

    Variation variation{std::string(text.substr(0, equals)), {}};
    for (std::size_t i = 0; i < count; ++i)
        variation.values.push_back(
            between(from, to, count == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(count - 1)));
    return variation;
}

}  // namespace normalscope

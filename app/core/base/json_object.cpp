#include "core/base/json_object.h"

#include "core/base/decimal.h"
#include "core/base/nearest.h"
#include "core/base/text.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace normalscope {

using Json = nlohmann::ordered_json;

namespace {

std::string said(const Range& range) {
    constexpr int kDigits = 15;  // no exponent below 1e15
    const std::string low = with_digits(range.low, kDigits);
    return range.high == kAnyNumber.high ? "at least " + low
                                         : "from " + low + " to " + with_digits(range.high, kDigits);
}

}  // namespace

std::string shown(const Json& json, std::size_t most_bytes) {
    return shortened(json.dump(-1, ' ', false, Json::error_handler_t::replace), most_bytes);
}

void fail_key(const JsonPath& path, std::span<const std::string> known) {
    const auto meant = nearest(path.back(), known);
    throw JsonError(
        path, "unknown key; " + (meant ? "did you mean " + *meant + "? Known here: " : "known here: ") + joined(known));
}

void fail_kind(const JsonPath& path, const std::string& expected, const Json& found) {
    throw JsonError(path, "expected " + expected + ", found " + shown(found));
}

void read_value(const Json& json, const JsonPath& path, bool& value) {
    if (!json.is_boolean()) fail_kind(path, "true or false", json);
    value = json.get<bool>();
}
void read_value(const Json& json, const JsonPath& path, std::string& value) {
    if (!json.is_string()) fail_kind(path, "a string", json);
    value = json.get<std::string>();
}
void read_value(const Json& json, const JsonPath& path, double& value, Range range) {
    if (!json.is_number()) fail_kind(path, "a number", json);
    const double number = json.get<double>();
    if (!(number >= range.low && number <= range.high))
        throw JsonError(path, shown(json) + " is out of range; it must be " + said(range));
    value = number;
}
void read_value(const Json& json, const JsonPath& path, int& value, Range range) {
    double number = 0.0;
    read_value(json, path, number, range);
    if (number != std::floor(number)) fail_kind(path, "a whole number", json);
    value = static_cast<int>(number);
}

JsonObject::JsonObject(const Json& json, JsonPath path, const std::string& expected)
    : json_(json), path_(std::move(path)) {
    if (!json.is_object()) fail_kind(path_, expected, json);
}

const Json* JsonObject::find(std::string_view key) {
    if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
    const auto it = json_.find(key);
    return it == json_.end() ? nullptr : &*it;
}

const Json& JsonObject::need(std::string_view key) {
    const Json* json = find(key);
    if (json) return *json;
    std::vector<std::string> there;  // one of which may be misspelt
    for (const auto& [other, ignored] : json_.items()) there.push_back(shortened(other, 20));
    throw JsonError(path_, "lacks the key " + std::string(key) + (there.empty() ? "" : "; it has " + joined(there)));
}

void JsonObject::read_format(std::string_view key) {
    const Json* json = find(key);
    if (!json) return;
    if (!json->is_number_integer()) fail_kind(at(key), "the format's number, 1", *json);
    if (*json != 1) throw JsonError(at(key), "format " + shown(*json) + " is not known; this program reads format 1");
}

void JsonObject::no_other_keys() const {
    for (const auto& [key, ignored] : json_.items())
        if (std::ranges::count(known_, key) == 0) fail_key(at(key), known_);
}

}  // namespace normalscope

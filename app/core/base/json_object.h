#pragma once

#include "core/base/json_path.h"
#include "core/base/range.h"

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

// The one strict reader of JSON from outside. What is not as it should be throws JsonError with its path.

/// The value as text, or its beginning.
std::string shown(const nlohmann::ordered_json& json, std::size_t most_bytes = 40);

/// "expected a number, found …".
[[noreturn]] void fail_kind(const JsonPath& path, const std::string& expected, const nlohmann::ordered_json& found);
/// Of a path whose last key there is not; with the one of the known that was probably meant.
[[noreturn]] void fail_key(const JsonPath& path, std::span<const std::string> known);

void read_value(const nlohmann::ordered_json& json, const JsonPath& path, bool& value);
void read_value(const nlohmann::ordered_json& json, const JsonPath& path, std::string& value);
void read_value(const nlohmann::ordered_json& json, const JsonPath& path, double& value, Range range);
void read_value(const nlohmann::ordered_json& json, const JsonPath& path, int& value, Range range);

/// An object whose keys are all known in the end: which ones, is what was asked for.
class JsonObject {
public:
    /// `expected` says what else there should be: "an object with the keys ask and choices".
    JsonObject(const nlohmann::ordered_json& json, JsonPath path, const std::string& expected = "an object");

    /// Null where it has no such key.
    const nlohmann::ordered_json* find(std::string_view key);
    const nlohmann::ordered_json& need(std::string_view key);
    /// A missing key leaves the value as it is.
    template <class Value, class... More>
    void read(std::string_view key, Value& value, const More&... more) {
        if (const nlohmann::ordered_json* json = find(key)) read_value(*json, at(key), value, more...);
    }
    /// The number of the format, always 1, that tells later programs how to read a file.
    void read_format(std::string_view key);
    void no_other_keys() const;

    JsonPath at(std::string_view key) const { return below(path_, std::string(key)); }
    const JsonPath& path() const { return path_; }

private:
    const nlohmann::ordered_json& json_;
    JsonPath path_;
    std::vector<std::string> known_;
};

}  // namespace normalscope

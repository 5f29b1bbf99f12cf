#include "core/base/json_reading.h"

#include "core/base/error.h"

#include <algorithm>
#include <string>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

int json_depth(std::string_view text) {
    int depth = 0, most = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            in_string = c != '"';
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            most = std::max(most, ++depth);
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return most;
}

Json read_json(std::string_view text, const std::string& source, int deepest) {
    if (json_depth(text) > deepest)
        throw InputError(source + ": nested more than " + std::to_string(deepest) +
                         " levels deep, which nothing here is");
    try {
        return Json::parse(text);
    } catch (const Json::exception& e) {
        std::string reason = e.what();  // without its head, "[json.exception…]"
        if (const auto end = reason.find("] "); reason.starts_with('[') && end != std::string::npos)
            reason.erase(0, end + 2);
        std::ranges::replace(reason, '\n', ' ');
        throw InputError(source + ": not valid JSON: " + reason);
    }
}

std::optional<Json> read_json_or_nothing(std::string_view text, int deepest) {
    if (json_depth(text) > deepest) return std::nullopt;
    Json value = Json::parse(text, nullptr, false);
    return value.is_discarded() ? std::nullopt : std::optional(std::move(value));
}

}  // namespace normalscope

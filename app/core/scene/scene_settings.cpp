#include "core/scene/scene_settings.h"

#include "core/scene/scene_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

bool same_keys(const Json& a, const Json& b) {
    if (a.size() != b.size()) return false;
    return std::ranges::all_of(a.items(), [&](const auto& item) { return b.contains(item.key()); });
}

// As people write it: a name needs no quotes.
std::string value_text(const Json& value) {
    const auto is_name = [](const std::string& text) {
        return !text.empty() &&
               std::ranges::all_of(text, [](unsigned char c) { return std::isalpha(c) || c == '-'; }) &&
               std::isalpha(static_cast<unsigned char>(text.front())) && text != "null" && text != "true" &&
               text != "false";
    };
    if (value.is_string() && is_name(value.get<std::string>())) return value.get<std::string>();
    return value.dump();
}

// Goes down as long as both have the same shape. Numbers stay together: all of a vector is no longer than its parts.
void collect(const Json& from, const Json& to, const std::string& path, std::vector<std::string>& settings) {
    if (from == to) return;
    const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
    const auto of_objects = [](const Json& j) { return j.is_array() && !j.empty() && j.front().is_object(); };
    if (from.is_object() && to.is_object() && same_keys(from, to)) {
        for (const auto& [key, value] : to.items()) collect(from[key], value, below(key), settings);
    } else if (of_objects(from) && of_objects(to) && from.size() == to.size()) {
        for (std::size_t i = 0; i < to.size(); ++i) collect(from[i], to[i], below(std::to_string(i)), settings);
    } else {
        settings.push_back(path + "=" + value_text(to));
    }
}

}  // namespace

std::vector<std::string> settings_between(const Scene& from, const Scene& to) {
    std::vector<std::string> settings;
    Json a = Json::parse(scene_text(from)), b = Json::parse(scene_text(to));
    a.erase("about");
    b.erase("about");
    collect(a, b, "", settings);
    return settings;
}

std::string shell_word(const std::string& text) {
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) || std::string_view("_-+=.,/:@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, plain)) return text;
    std::string word = "'";
    for (const char c : text)
        if (c == '\'')
            word += "'\\''";
        else
            word += c;
    return word + "'";
}

}  // namespace normalscope

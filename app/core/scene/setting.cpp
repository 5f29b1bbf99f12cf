#include "core/scene/setting.h"

#include "core/base/json_object.h"
#include "core/base/json_reading.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/formula/formula.h"
#include "core/scene/scene_json.h"

#include <algorithm>
#include <cctype>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

JsonPath keys_of(std::string_view path) {
    JsonPath keys{""};
    for (const char c : path)
        if (c == '.')
            keys.emplace_back();
        else
            keys.back() += c;
    return keys;
}

Json value_of(const std::string& text) {
    if (std::optional<Json> value = read_json_or_nothing(text)) return *std::move(value);
    if (text.starts_with('[') || text.starts_with('{') || text.starts_with('"'))
        throw JsonError({}, shortened(text, 60) + " is not valid JSON; a bracket or a quote is missing");
    return text;
}

Json& element(Json& array, const JsonPath& path) {
    const std::string& key = path.back();
    const bool digits =
        !key.empty() && key.size() < 7 && std::ranges::all_of(key, [](char c) { return c >= '0' && c <= '9'; });
    const std::size_t index = digits ? static_cast<std::size_t>(std::stoul(key)) : array.size() + 1;
    // One past the end of the stack appends an entry.
    if (index == array.size() && path.size() == 2 && path[0] == "stack") array.push_back(Json::object());
    if (index >= array.size())
        throw JsonError(path, "no such entry; there are " + std::to_string(array.size()) + ", counted from 0");
    return array[index];
}

// The keys of which the object at `path` has one.
std::span<const std::string> kinds_at(const JsonPath& path) {
    if (path.size() == 1 && path[0] == "surface") return surface_kinds();
    if (path.size() == 2 && path[0] == "stack") return stack_kinds();
    return {};
}

Json& member(Json& object, const JsonPath& path) {
    const std::string& key = path.back();
    const JsonPath parent(path.begin(), path.end() - 1);
    // What is off is switched on by setting a part of it.
    if (object.is_null() && parent.size() == 1) object = json_when_on(parent[0]);
    // A kind of surface or entry that has just been put there has no parts yet.
    if (object.is_null() && !parent.empty() &&
        std::ranges::count(kinds_at(JsonPath(parent.begin(), parent.end() - 1)), parent.back()) > 0)
        throw JsonError(parent, "there is none here yet, so a part of it cannot be set; set all of it");
    if (!object.is_object()) throw JsonError(path, "there is nothing below " + shown(object));
    // Another kind of surface or of entry replaces the one that is there.
    const std::span<const std::string> kinds = kinds_at(parent);
    if (std::ranges::count(kinds, key) > 0 && !object.contains(key)) object = Json{{key, nullptr}};
    if (!object.contains(key)) {
        std::vector<std::string> known;
        for (const auto& [k, v] : object.items()) known.push_back(k);
        if (known.empty()) known.assign(kinds.begin(), kinds.end());
        if (known.empty()) throw JsonError(path, "there is nothing below " + shown(object));
        fail_key(path, known);
    }
    return object[key];
}

// Another formula has other parameters.
void keep_parameters(Json& surface) {
    const std::string known = formulas::parameters_in(surface["formula"].get<std::string>());
    const Json before = surface.value("parameters", Json::object());
    Json& kept = surface["parameters"] = Json::object();
    for (const auto& [key, number] : before.items())
        if (known.find(key) != std::string::npos) kept[key] = number;
}

bool same_keys(const Json& a, const Json& b) {
    if (a.size() != b.size()) return false;
    return std::ranges::all_of(a.items(), [&](const auto& item) { return b.contains(item.key()); });
}

// Goes down as long as both have the same shape. Numbers stay together: all of a vector is no longer than its parts.
void collect(const Json& from, const Json& to, const std::string& path, std::vector<Setting>& settings) {
    if (from == to) return;
    const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
    const auto of_objects = [](const Json& j) { return j.is_array() && !j.empty() && j.front().is_object(); };
    if (from.is_object() && to.is_object() && same_keys(from, to)) {
        for (const auto& [key, value] : to.items()) collect(from[key], value, below(key), settings);
    } else if (of_objects(from) && of_objects(to) && from.size() == to.size()) {
        for (std::size_t i = 0; i < to.size(); ++i) collect(from[i], to[i], below(std::to_string(i)), settings);
    } else {
        settings.push_back({path, to});
    }
}

bool is_name(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isalpha(c) || c == '-'; }) &&
           std::isalpha(static_cast<unsigned char>(text.front())) && text != "null" && text != "true" &&
           text != "false";
}

}  // namespace

std::string Setting::text() const {
    if (value.is_string() && is_name(value.get_ref<const std::string&>())) return path + "=" + value.get<std::string>();
    return path + "=" + value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Setting parse_setting(std::string_view text) {
    const auto equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        throw UsageError("--set " + shortened(text, 60),
                         "expected PATH=VALUE, such as stack.0.scale=[1,2,1] or rule=naive");
    const std::string path(text.substr(0, equals)), value(text.substr(equals + 1));
    try {
        Json json = value_of(value);
        if (path == "surface.formula" && !json.is_string()) json = value;  // a formula may look like a number
        return {path, std::move(json)};
    } catch (const JsonError& e) {
        throw UsageError("--set " + dotted(keys_of(path)), e.what());
    }
}

Scene with_setting(const Scene& scene, const Setting& setting) {
    Json root = scene_json(scene);
    Json* node = &root;
    JsonPath path;  // of `node`
    for (const std::string& key : keys_of(setting.path)) {
        // As it was given, since a path that ends in nothing cannot be told from a shorter one.
        if (key.empty()) throw JsonError({setting.path}, "expected keys with a dot between them, as in stack.0.scale");
        path.push_back(key);
        node = &(node->is_array() ? element(*node, path) : member(*node, path));
    }
    *node = setting.value;
    if (setting.path == "surface.formula" && node->is_string()) keep_parameters(root["surface"]);
    Scene result = scene_of_json(root);
    if (!same_subject(result, scene)) result.about.clear();
    return result;
}

Scene with_setting(const Scene& scene, std::string_view assignment) {
    try {
        return with_setting(scene, parse_setting(assignment));
    } catch (const JsonError& e) {
        throw UsageError("--set " + std::string(e.what()));
    }
}

std::vector<Setting> settings_between(const Scene& from, const Scene& to) {
    std::vector<Setting> settings;
    Json a = scene_json(from), b = scene_json(to);
    a.erase("about");
    b.erase("about");
    collect(a, b, "", settings);
    return settings;
}

}  // namespace normalscope

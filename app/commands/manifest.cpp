#include "commands/manifest.h"

#include "cli/values.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_object.h"
#include "core/base/json_reading.h"
#include "core/base/utf8.h"
#include "core/lessons/link.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace normalscope {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestManifest = std::size_t{16} << 20;
constexpr double kWithin = 1e-9;  // of 1, or of a larger number itself

enum class Kind { Number, Text };

/// `read(option, text)` reads it as the command line's option is read.
template <class Value, class Read>
void read_option(JsonObject& object, const char* key, Kind kind, Value& value, Read&& read) {
    const Json* json = object.find(key);
    if (!json) return;
    if (kind == Kind::Number && !json->is_number()) fail_kind(object.at(key), "a number", *json);
    if (kind == Kind::Text && !json->is_string()) fail_kind(object.at(key), "a string", *json);
    const std::string text = json->is_string() ? json->get<std::string>() : json->dump();
    try {
        value = read("", text);
    } catch (const UsageError& e) {
        throw JsonError(object.at(key), shortened(text, 40) + ": " + e.reason);
    }
}

// What a check has, and the manifest itself has for all of them.
void read_how(JsonObject& object, Check& check) {
    read_option(object, "size", Kind::Text, check.picture.size, parse_size);
    read_option(object, "samples", Kind::Number, check.picture.samples, parse_samples);
    read_option(object, "ground", Kind::Text, check.picture.ground, parse_ground);
    read_option(object, "scale", Kind::Number, check.picture.scale, parse_scale);
    object.read("panel", check.picture.panel);
    object.read("tab", check.picture.tab);
    object.read("captions", check.picture.captions);
    read_option(object, "tolerance", Kind::Number, check.tolerance.channel, parse_tolerance);
    read_option(object, "share", Kind::Number, check.tolerance.share, parse_share);
    object.read("perceptual", check.tolerance.perceived);
}

void read_file_name(JsonObject& object, const char* key, std::string& name) {
    object.read(key, name);
    if (object.find(key) && name.empty()) throw JsonError(object.at(key), "is empty");
}

// A scene's name or link, or a file's from the manifest's folder.
std::string scene_from(const fs::path& folder, const std::string& scene) {
    if (is_link(scene)) return scene;
    std::error_code ignored;
    const fs::path file = folder / scene;
    return fs::path(scene).has_extension() || fs::exists(file, ignored) ? file.lexically_normal().string() : scene;
}

void read_settings(JsonObject& object, std::vector<std::string>& settings) {
    const Json* list = object.find("set");
    if (!list) return;
    const std::string expected = R"(an array of strings, such as ["rule=naive"])";
    if (!list->is_array()) fail_kind(object.at("set"), expected, *list);
    for (const Json& setting : *list)
        if (!setting.is_string()) fail_kind(object.at("set"), expected, *list);
    settings = list->get<std::vector<std::string>>();
}

bool holds_numbers(const Json& json) {
    return json.is_number() || (json.is_array() && !json.empty() && std::ranges::all_of(json, holds_numbers));
}

// By dotted path, a value each, or {"is": VALUE, "within": NUMBER}.
void read_numbers(JsonObject& object, Json& numbers) {
    const Json* json = object.find("numbers");
    if (!json) return;
    const JsonPath path = object.at("numbers");
    if (!json->is_object()) fail_kind(path, R"(an object, such as {"determinant": 1})", *json);
    for (const auto& [key, value] : json->items()) {
        if (!value.is_object()) continue;
        JsonObject tolerant(value, below(path, key));
        const bool numbers_alone = holds_numbers(tolerant.need("is"));
        if (value.contains("within") && !numbers_alone)
            throw JsonError(tolerant.at("within"),
                            "is for numbers, and " + shown(tolerant.need("is")) + ", which is expected, is not one");
        double within = 0.0;
        tolerant.read("within", within, Range{0.0, kAnyNumber.high});
        tolerant.no_other_keys();
    }
    numbers = *json;
}

Check read_check(const Json& json, const JsonPath& path, const fs::path& folder, const Check& usual) {
    JsonObject object(json, path);
    Check check = usual;
    std::string scene, reference;
    (void)object.need("scene");
    read_file_name(object, "scene", scene);
    check.name = fs::path(scene).stem().string();
    object.read("name", check.name);
    if (check.name.empty()) throw JsonError(object.at("name"), "is empty");
    check.picture.file = scene_from(folder, scene);
    read_settings(object, check.picture.settings);
    read_how(object, check);
    read_numbers(object, check.numbers);
    read_file_name(object, "reference", reference);
    object.no_other_keys();
    if (reference.empty() && check.numbers.empty())
        throw JsonError(path, "has neither a reference nor numbers, so it checks nothing");
    if (!reference.empty()) check.reference = (folder / reference).lexically_normal();
    return check;
}

std::vector<Check> read_checks(const Json& json, const fs::path& folder) {
    JsonObject manifest(json, {});
    (void)manifest.need("normalscope_check");
    manifest.read_format("normalscope_check");
    Check usual;
    read_how(manifest, usual);
    const Json& list = manifest.need("checks");
    const JsonPath path = manifest.at("checks");
    if (!list.is_array() || list.empty()) fail_kind(path, "an array of one or more", list);
    manifest.no_other_keys();

    std::vector<Check> checks;
    std::set<std::string> names;
    for (std::size_t i = 0; i < list.size(); ++i) {
        checks.push_back(read_check(list[i], below(path, i), folder, usual));
        if (!names.insert(checks.back().name).second)
            throw JsonError(below(path, i),
                            "there is a check named " + checks.back().name + " already; give this one another name");
    }
    return checks;
}

bool agree(const Json& found, const Json& expected, std::optional<double> within) {
    if (expected.is_number() && found.is_number()) {
        const double wanted = expected.get<double>();
        return std::abs(found.get<double>() - wanted) <= within.value_or(kWithin * std::max(1.0, std::abs(wanted)));
    }
    if (!expected.is_array() || !found.is_array()) return found == expected;
    if (found.size() != expected.size()) return false;
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (!agree(found[i], expected[i], within)) return false;
    return true;
}

const Json* at_path(const Json& numbers, const std::string& path) {
    const Json* node = &numbers;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        const std::string key = path.substr(begin, end - begin);
        if (node->is_array()) {
            const bool digits = !key.empty() && key.size() < 7 &&
                                std::ranges::all_of(key, [](unsigned char c) { return std::isdigit(c) != 0; });
            if (!digits || std::stoul(key) >= node->size()) return nullptr;
            node = &(*node)[std::stoul(key)];
        } else {
            const auto it = node->find(key);
            if (it == node->end()) return nullptr;
            node = &*it;
        }
        begin = end + 1;
    }
    return node;
}

}  // namespace

std::vector<Check> read_manifest(const fs::path& file) {
    try {
        return read_checks(read_json(read_file(file, kLargestManifest)), file.parent_path());
    } catch (const JsonError& e) {
        throw InputError(file.string(), e.what());
    }
}

std::vector<std::string> wrong_numbers(const Json& numbers, const Json& expected) {
    std::vector<std::string> lines;
    for (const auto& [path, wanted] : expected.items()) {
        const bool with_tolerance = wanted.is_object() && wanted.contains("is");
        const Json& value = with_tolerance ? wanted["is"] : wanted;
        std::optional<double> within;
        if (with_tolerance && wanted.contains("within") && wanted["within"].is_number())
            within = wanted["within"].get<double>();
        const Json* found = at_path(numbers, path);
        if (!found)
            lines.push_back(path + ": there is no such number");
        else if (!agree(*found, value, within))
            lines.push_back(path + " is " + shown(*found, 80) + ", expected " + shown(value, 80) +
                            (within ? " within " + shown(*within) : ""));
    }
    return lines;
}

}  // namespace normalscope

#include "commands/manifest.h"

#include "cli/values.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_reading.h"
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
constexpr int kDeepest = 16;
constexpr double kWithin = 1e-9;

/// One object of the manifest, and where it stands, for errors.
class Keys {
public:
    Keys(const Json& json, std::string path) : json_(json), path_(std::move(path)) {
        if (!json.is_object()) throw InputError(path_ + ": expected an object");
    }

    const Json* find(const char* key) {
        known_.emplace_back(key);
        const auto it = json_.find(key);
        return it == json_.end() ? nullptr : &*it;
    }
    /// `read(option, text)` as the command line's options are read.
    template <class Value, class Read>
    void text(const char* key, Value& value, Read&& read) {
        const Json* j = find(key);
        if (!j) return;
        try {
            value = read(at(key) + ":", j->is_string() ? j->get<std::string>() : j->dump());
        } catch (const UsageError& e) {
            throw InputError(e.what());
        }
    }
    void flag(const char* key, bool& value) {
        const Json* j = find(key);
        if (!j) return;
        if (!j->is_boolean()) throw InputError(at(key) + ": expected true or false");
        value = j->get<bool>();
    }
    void string(const char* key, std::string& value) {
        const Json* j = find(key);
        if (!j) return;
        if (!j->is_string()) throw InputError(at(key) + ": expected a string");
        value = j->get<std::string>();
    }
    void no_other_keys() const {
        for (const auto& [key, value] : json_.items())
            if (std::ranges::count(known_, key) == 0) {
                std::string line = path_ + " " + key + ": unknown key; known here:";
                for (const std::string& k : known_) line += " " + k;
                throw InputError(line);
            }
    }
    std::string at(const std::string& key) const { return path_ + " " + key; }

private:
    const Json& json_;
    std::string path_;
    std::vector<std::string> known_;
};

// What a check has, and the manifest itself has for all of them.
void read_how(Keys& object, Check& check) {
    object.text("size", check.picture.size, parse_size);
    object.text("samples", check.picture.samples, parse_samples);
    object.text("ground", check.picture.ground, parse_ground);
    object.text("scale", check.picture.scale, parse_scale);
    object.flag("panel", check.picture.panel);
    object.string("tab", check.picture.tab);
    object.flag("captions", check.picture.captions);
    object.text("tolerance", check.tolerance.channel, parse_tolerance);
    object.text("share", check.tolerance.share, parse_share);
    object.flag("perceptual", check.tolerance.perceived);
}

// A scene's name or link, or a file's from the manifest's folder.
std::string scene_from(const fs::path& folder, const std::string& scene) {
    if (is_link(scene)) return scene;
    std::error_code ignored;
    const fs::path file = folder / scene;
    return fs::path(scene).has_extension() || fs::exists(file, ignored) ? file.lexically_normal().string() : scene;
}

void read_settings(Keys& object, std::vector<std::string>& settings) {
    const Json* list = object.find("set");
    if (!list) return;
    if (!list->is_array() || !std::ranges::all_of(*list, [](const Json& j) { return j.is_string(); }))
        throw InputError(object.at("set") + R"(: expected an array of strings, such as ["rule=naive"])");
    settings = list->get<std::vector<std::string>>();
}

Check read_check(const Json& json, const std::string& path, const fs::path& folder, const Check& usual) {
    Keys object(json, path);
    Check check = usual;
    std::string scene = check.picture.file;
    object.string("scene", scene);
    check.name = fs::path(scene).stem().string();
    object.string("name", check.name);
    if (check.name.empty()) throw InputError(object.at("name") + ": is empty");
    check.picture.file = scene_from(folder, scene);
    read_settings(object, check.picture.settings);
    read_how(object, check);
    if (const Json* numbers = object.find("numbers")) {
        if (!numbers->is_object())
            throw InputError(object.at("numbers") + R"(: expected an object, such as {"determinant": 1})");
        check.numbers = *numbers;
    }
    const Json* reference = object.find("reference");
    if (!reference && check.numbers.empty())
        throw InputError(path + ": has neither a reference nor numbers, so it checks nothing");
    if (reference && !reference->is_string())
        throw InputError(object.at("reference") + ": expected a picture's file name");
    if (reference) check.reference = (folder / reference->get<std::string>()).lexically_normal();
    object.no_other_keys();
    return check;
}

std::string shown(const Json& j) { return j.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 80); }

bool agree(const Json& found, const Json& expected, double within) {
    if (expected.is_number() && found.is_number())
        return std::abs(found.get<double>() - expected.get<double>()) <= within;
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
    const Json json = read_json(read_file(file, kLargestManifest), file.string(), kDeepest);
    const fs::path folder = file.parent_path();
    Keys manifest(json, file.string() + ":");
    const Json* version = manifest.find("normalscope_check");
    if (!version || *version != 1)
        throw InputError(manifest.at("normalscope_check") + ": must be 1, the number of the format that is read here");
    Check usual;
    read_how(manifest, usual);
    const Json* list = manifest.find("checks");
    if (!list || !list->is_array() || list->empty())
        throw InputError(manifest.at("checks") + ": expected an array of one or more");
    manifest.no_other_keys();

    std::vector<Check> checks;
    std::set<std::string> names;
    for (std::size_t i = 0; i < list->size(); ++i) {
        checks.push_back(read_check((*list)[i], file.string() + ": checks." + std::to_string(i), folder, usual));
        if (!names.insert(checks.back().name).second)
            throw InputError(file.string() + ": checks." + std::to_string(i) + ": there is a check named " +
                             checks.back().name + " already; give this one another name");
    }
    return checks;
}

std::vector<std::string> wrong_numbers(const Json& numbers, const Json& expected) {
    std::vector<std::string> lines;
    for (const auto& [path, wanted] : expected.items()) {
        const bool with_tolerance = wanted.is_object() && wanted.contains("is");
        const Json& value = with_tolerance ? wanted["is"] : wanted;
        const double within = with_tolerance && wanted.contains("within") && wanted["within"].is_number()
                                  ? wanted["within"].get<double>()
                                  : kWithin;
        const Json* found = at_path(numbers, path);
        if (!found)
            lines.push_back(path + ": there is no such number");
        else if (!agree(*found, value, within))
            lines.push_back(path + " is " + shown(*found) + ", expected " + shown(value) + " within " + shown(within));
    }
    return lines;
}

}  // namespace normalscope

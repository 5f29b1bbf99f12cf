#include "core/lessons/scene_path.h"

#include "core/base/json_object.h"
#include "core/scene/setting.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostKeys = 4, kMostValues = 100, kMostNumbers = 16;
constexpr const char* kExpected = "an array of 2 to 100 values, numbers or arrays of as many numbers";

std::vector<double> read_waypoint(const Json& json, const JsonPath& path) {
    std::vector<double> numbers;
    if (!json.is_array()) {
        read_value(json, path, numbers.emplace_back(), kAnyNumber);
        return numbers;
    }
    if (json.size() < 2 || json.size() > kMostNumbers) fail_kind(path, "a number, or an array of 2 to 16", json);
    for (std::size_t i = 0; i < json.size(); ++i)
        read_value(json[i], below(path, i), numbers.emplace_back(), kAnyNumber);
    return numbers;
}

ScenePath read_path(const std::string& key, const Json& json, const JsonPath& path) {
    if (!json.is_array() || json.size() < 2 || json.size() > kMostValues) fail_kind(path, kExpected, json);
    ScenePath result{key, {}};
    for (std::size_t i = 0; i < json.size(); ++i) result.values.push_back(read_waypoint(json[i], below(path, i)));
    for (const std::vector<double>& value : result.values)
        if (value.size() != result.values.front().size()) fail_kind(path, kExpected, json);
    return result;
}

Setting setting(const ScenePath& path, const std::vector<double>& numbers) {
    return {path.key, numbers.size() == 1 ? Json(numbers.front()) : Json(numbers)};
}

// Between two of the values, at t from 0 to 1 of all.
std::vector<double> value_at(const ScenePath& path, double t) {
    const double place = t * static_cast<double>(path.values.size() - 1);
    const auto leg = std::min(static_cast<std::size_t>(place), path.values.size() - 2);
    const double share = place - static_cast<double>(leg);
    std::vector<double> value = path.values[leg];
    for (std::size_t i = 0; i < value.size(); ++i) value[i] += share * (path.values[leg + 1][i] - value[i]);
    return value;
}

Scene at(Scene scene, std::span<const ScenePath> paths, double t) {
    for (const ScenePath& path : paths)
        scene = with_setting(scene, setting(path, t >= 1.0 ? path.values.back() : value_at(path, t)));
    return scene;
}

}  // namespace

std::vector<ScenePath> read_paths(const Json& json, const JsonPath& path, const Scene& scene) {
    if (!json.is_object() || json.empty() || json.size() > kMostKeys)
        fail_kind(path, "an object of 1 to 4 keys of the scene, such as probe, and their values in turn", json);
    std::vector<ScenePath> paths;
    for (const auto& [key, values] : json.items()) {
        paths.push_back(read_path(key, values, below(path, key)));
        for (std::size_t i = 0; i < paths.back().values.size(); ++i) try {
                (void)with_setting(scene, setting(paths.back(), paths.back().values[i]));
            } catch (const JsonError& e) {
                throw JsonError(below(below(path, key), i), e.what());
            }
    }
    return paths;
}

Scene on_path(const Scene& scene, std::span<const ScenePath> paths, double t) {
    t = std::clamp(t, 0.0, 1.0);
    try {
        return at(scene, paths, t * t * (3.0 - 2.0 * t));
    } catch (const InputError&) {
        return at(scene, paths, 1.0);
    }
}

}  // namespace normalscope

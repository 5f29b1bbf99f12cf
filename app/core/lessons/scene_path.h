#pragma once

#include "core/base/json_path.h"
#include "core/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace normalscope {

/// What a step shows once when it is reached: a key of the scene goes through some values, and ends at the last of them.
struct ScenePath {
    static constexpr double kSeconds = 3.0;  ///< for all of it

    std::string key;  ///< a dotted path, as `--set` has it
    std::vector<std::vector<double>>
        values;  ///< at least two, alike in size; one number each where the key is a number
    friend bool operator==(const ScenePath&, const ScenePath&) = default;
};

/// An object of keys and their values in turn. Throws JsonError for what some scene on the way could not be: it begins at
/// this one.
std::vector<ScenePath> read_paths(const nlohmann::ordered_json& json, const JsonPath& path, const Scene& scene);

/// The scene at t from 0 to 1 of the way, which begins and ends gently. Where one on the way cannot be, it is the last.
Scene on_path(const Scene& scene, std::span<const ScenePath> paths, double t);

}  // namespace normalscope

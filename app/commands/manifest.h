#pragma once

#include "cli/commands.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// One of a manifest's checks: a scene, and what its picture and its numbers must be.
struct Check {
    std::string name;
    PictureArguments picture;
    std::optional<std::filesystem::path> reference;
    Tolerance tolerance;
    nlohmann::ordered_json numbers;  ///< what is expected, by dotted path, as they stand in the manifest
};

/// The checks of `normalscope check MANIFEST.json`, all paths from its folder. Throws InputError with the path of what is
/// wrong, such as "checks.json: checks.3.size: …".
std::vector<Check> read_manifest(const std::filesystem::path& file);

/// What is wrong with numbers (as --numbers writes them), one line each: "error_degrees.bound is 36.87, expected …".
std::vector<std::string> wrong_numbers(const nlohmann::ordered_json& numbers, const nlohmann::ordered_json& expected);

}  // namespace normalscope

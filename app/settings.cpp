#include "settings.h"

#include "core/error.h"
#include "core/file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

std::optional<std::filesystem::path> settings_file() {
    const auto from = [](const char* variable) {
        const char* value = std::getenv(variable);
        return std::filesystem::path(value ? value : "");
    };
    if (const auto config = from("XDG_CONFIG_HOME"); config.is_absolute())
        return config / "normalscope" / "settings.json";
    if (const auto home = from("HOME"); home.is_absolute()) return home / ".config" / "normalscope" / "settings.json";
    return std::nullopt;
}

std::optional<glm::ivec2> pair(const Json& json, const char* key) {
    const auto it = json.find(key);
    if (it == json.end() || !it->is_array() || it->size() != 2 || !(*it)[0].is_number_integer() ||
        !(*it)[1].is_number_integer())
        return std::nullopt;
    return glm::ivec2(std::clamp((*it)[0].get<int>(), -30000, 30000), std::clamp((*it)[1].get<int>(), -30000, 30000));
}

}  // namespace

Settings load_settings() {
    Settings settings;
    const auto file = settings_file();
    if (!file) return settings;
    try {
        const Json json = Json::parse(read_file(*file, 1 << 16));
        if (const auto size = pair(json, "window_size"); size && size->x >= 480 && size->y >= 320)
            settings.place.size = *size;
        settings.place.position = pair(json, "window_position");
    } catch (const std::exception&) {
        return Settings{};
    }
    return settings;
}

void save_settings(const Settings& settings) {
    const auto file = settings_file();
    if (!file) return;
    std::error_code error;
    std::filesystem::create_directories(file->parent_path(), error);
    Json json;
    json["window_size"] = {settings.place.size.x, settings.place.size.y};
    if (settings.place.position) json["window_position"] = {settings.place.position->x, settings.place.position->y};
    try {
        write_file(*file, json.dump(2) + "\n");
    } catch (const Error&) {
        return;
    }
}

}  // namespace normalscope

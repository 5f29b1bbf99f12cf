#include "desktop/settings.h"

#include "core/base/error.h"
#include "core/base/file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostLessons = 200;

std::optional<std::filesystem::path> settings_file() {
    const auto folder = settings_folder();
    return folder ? std::optional(*folder / "settings.json") : std::nullopt;
}

std::optional<glm::ivec2> pair(const Json& json, const char* key) {
    const auto it = json.find(key);
    if (it == json.end() || !it->is_array() || it->size() != 2 || !(*it)[0].is_number_integer() ||
        !(*it)[1].is_number_integer())
        return std::nullopt;
    return glm::ivec2(std::clamp((*it)[0].get<int>(), -30000, 30000), std::clamp((*it)[1].get<int>(), -30000, 30000));
}

double factor(const Json& json, const char* key) {
    const auto it = json.find(key);
    return it != json.end() && it->is_number() ? std::clamp(it->get<double>(), 0.6, 3.0) : 1.0;
}

std::map<std::string, std::size_t> steps(const Json& json) {
    std::map<std::string, std::size_t> result;
    const auto it = json.find("lessons");
    if (it == json.end() || !it->is_object()) return result;
    for (const auto& [lesson, step] : it->items())
        if (step.is_number_unsigned() && result.size() < kMostLessons) result[lesson] = step.get<std::size_t>();
    return result;
}

}  // namespace

std::optional<std::filesystem::path> settings_folder() {
    const auto from = [](const char* variable) {
        const char* value = std::getenv(variable);
        return std::filesystem::path(value ? value : "");
    };
    if (const auto config = from("XDG_CONFIG_HOME"); config.is_absolute()) return config / "normalscope";
    if (const auto home = from("HOME"); home.is_absolute()) return home / ".config" / "normalscope";
    return std::nullopt;
}

Settings load_settings() {
    Settings settings;
    const auto file = settings_file();
    if (!file) return settings;
    try {
        const Json json = Json::parse(read_file(*file, 1 << 16));
        if (const auto size = pair(json, "window_size"); size && size->x >= 480 && size->y >= 320)
            settings.place.size = *size;
        settings.place.position = pair(json, "window_position");
        if (const auto it = json.find("window_maximised"); it != json.end() && it->is_boolean())
            settings.place.maximised = it->get<bool>();
        settings.remembered.scale.interface = factor(json, "interface_scale");
        settings.remembered.scale.presenter = factor(json, "presenter_scale");
        settings.remembered.lessons = steps(json);
        if (const auto motion = json.find("motion"); motion != json.end() && motion->is_boolean())
            settings.remembered.motion = motion->get<bool>();
        if (const auto monitor = json.find("monitor"); monitor != json.end() && monitor->is_string())
            settings.monitor = monitor->get<std::string>();
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
    if (settings.place.size) json["window_size"] = {settings.place.size->x, settings.place.size->y};
    if (settings.place.position) json["window_position"] = {settings.place.position->x, settings.place.position->y};
    if (settings.place.maximised) json["window_maximised"] = true;
    json["interface_scale"] = settings.remembered.scale.interface;
    json["presenter_scale"] = settings.remembered.scale.presenter;
    if (!settings.remembered.motion) json["motion"] = false;
    if (!settings.monitor.empty()) json["monitor"] = settings.monitor;
    for (const auto& [lesson, step] : settings.remembered.lessons) json["lessons"][lesson] = step;
    try {
        write_file(*file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    } catch (const Error&) {
        return;
    }
}

}  // namespace normalscope

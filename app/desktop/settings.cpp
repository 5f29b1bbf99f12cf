#include "desktop/settings.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/system.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

std::optional<std::filesystem::path> settings_folder() {
    const std::filesystem::path folder = settings_folder_of("normalscope");
    return folder.empty() ? std::nullopt : std::optional(folder);
}

Settings load_settings() {
    Settings settings{.remembered = remembered_of("")};
    const auto file = settings_file();
    if (!file) return settings;
    try {
        const std::string text = read_file(*file, 1 << 16);
        const Json json = Json::parse(text);
        if (const auto size = pair(json, "window_size"); size && size->x >= 480 && size->y >= 320)
            settings.place.size = *size;
        settings.place.position = pair(json, "window_position");
        if (const auto it = json.find("window_maximised"); it != json.end() && it->is_boolean())
            settings.place.maximised = it->get<bool>();
        settings.remembered = remembered_of(text);
        if (const auto monitor = json.find("monitor"); monitor != json.end() && monitor->is_string())
            settings.monitor = monitor->get<std::string>();
    } catch (const std::exception&) {
        return {.remembered = remembered_of("")};
    }
    return settings;
}

void save_settings(const Settings& settings) {
    const auto file = settings_file();
    if (!file) return;
    std::error_code error;
    std::filesystem::create_directories(file->parent_path(), error);
    Json json = Json::parse(remembered_text(settings.remembered));
    if (settings.place.size) json["window_size"] = {settings.place.size->x, settings.place.size->y};
    if (settings.place.position) json["window_position"] = {settings.place.position->x, settings.place.position->y};
    if (settings.place.maximised) json["window_maximised"] = true;
    if (!settings.monitor.empty()) json["monitor"] = settings.monitor;
    try {
        write_file(*file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    } catch (const Error&) {
        return;
    }
}

}  // namespace normalscope

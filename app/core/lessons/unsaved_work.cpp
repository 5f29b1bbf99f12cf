#include "core/lessons/unsaved_work.h"

#include "core/base/error.h"
#include "core/base/json_object.h"
#include "core/base/json_reading.h"
#include "core/lessons/open.h"
#include "core/scene/scene_json.h"

#include <filesystem>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

Scene portable(Scene scene) {
    if (auto* surface = std::get_if<MeshSurface>(&scene.surface)) surface->mesh = fs::absolute(surface->mesh).string();
    return scene;
}

// The name of what is built in stays what it is.
std::string portable(const std::string& file) {
    std::error_code error;
    return !file.empty() && fs::exists(file, error) ? fs::absolute(file).string() : file;
}

UnsavedWork read_work(const Json& json, const JsonPath& path) {
    JsonObject object(json, path);
    UnsavedWork work;
    object.read("file", work.file);
    work.scene = scene_of_json(object.need("scene"), object.at("scene"));
    object.no_other_keys();
    return work;
}

}  // namespace

std::string unsaved_text(std::span<const UnsavedWork> works) {
    Json json = Json::array();
    for (const UnsavedWork& work : works)
        json.push_back({{"file", portable(work.file)}, {"scene", scene_json(portable(work.scene))}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<UnsavedWork> parse_unsaved(std::string_view text, const std::string& source) {
    try {
        const Json json = read_json(text);
        if (!json.is_array()) fail_kind({}, "an array of scenes", json);
        std::vector<UnsavedWork> works;
        for (std::size_t i = 0; i < json.size(); ++i) works.push_back(read_work(json[i], below({}, i)));
        return works;
    } catch (const JsonError& e) {
        throw InputError(source, e.what());
    }
}

std::optional<Scene> saved_scene(const std::string& file) {
    if (file.empty()) return std::nullopt;
    try {
        Contents contents = open_name(file);
        if (auto* scene = std::get_if<Scene>(&contents)) return std::move(*scene);
    } catch (const InputError&) {
        return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace normalscope

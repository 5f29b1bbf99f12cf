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

// Meshes are named from the root, so that they are found from anywhere.
fs::path in_root() {
    std::error_code ignored;
    return fs::absolute(".", ignored).root_path() / "lesson.json";
}

Draft read_draft(JsonObject& object, const std::string& name) {
    const Json* json = object.find("lesson");
    if (!json) return {};
    const std::string text = json->dump();
    Draft draft{std::make_shared<const Lesson>(parse_lesson({text, name, in_root().parent_path()})), 0};
    int step = 0;
    object.read("step", step, Range{0, static_cast<double>(draft.lesson->steps.size() - 1)});
    draft.step = static_cast<std::size_t>(step);
    return draft;
}

Json work_json(const UnsavedWork& work) {
    Json json{{"file", portable(work.file)}, {"scene", scene_json(portable(work.scene))}};
    if (!work.draft.lesson) return json;
    json["lesson"] = Json::parse(lesson_text(*work.draft.lesson, in_root()));
    json["step"] = work.draft.step;
    return json;
}

UnsavedWork read_work(const Json& json, const JsonPath& path) {
    JsonObject object(json, path);
    UnsavedWork work;
    object.read("file", work.file);
    work.scene = scene_of_json(object.need("scene"), object.at("scene"));
    work.draft = read_draft(object, work.file);
    object.no_other_keys();
    return work;
}

}  // namespace

std::string unsaved_text(std::span<const UnsavedWork> works) {
    Json json = Json::array();
    for (const UnsavedWork& work : works) json.push_back(work_json(work));
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

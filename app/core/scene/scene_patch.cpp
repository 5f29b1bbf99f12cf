#include "core/scene/scene_patch.h"

#include "core/base/error.h"
#include "core/scene/scene_json.h"

#include <nlohmann/json.hpp>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

void merge(Json& into, const Json& patch) {
    for (const auto& [key, value] : patch.items()) {
        Json& old = into[key];
        bool replace = !value.is_object() || !old.is_object();
        if (key == "surface" && !replace)  // another formula has other parameters
            for (const auto& [kind, ignored] : value.items()) replace |= !old.contains(kind) || kind == "formula";
        if (replace)
            old = value;
        else
            merge(old, value);
    }
}

}  // namespace

Scene with_patch(const Scene& scene, std::string_view patch, std::string_view source) {
    const Json changes = Json::parse(patch, nullptr, false);
    // What is no patch is told as what is no scene.
    if (!changes.is_object()) return parse_scene(patch, source);
    Json root = Json::parse(scene_text(scene));
    merge(root, changes);
    Scene result = parse_scene(root.dump(-1, ' ', false, Json::error_handler_t::replace), source);
    if (!changes.contains("about") && !same_subject(result, scene)) result.about.clear();
    return result;
}

}  // namespace normalscope

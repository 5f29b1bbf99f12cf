#include "core/scene/scene_patch.h"

#include "core/base/json_object.h"
#include "core/scene/scene_json.h"

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

Scene with_patch(const Scene& scene, const Json& patch, const JsonPath& path) {
    if (!patch.is_object()) fail_kind(path, "an object: the scene's keys that change", patch);
    Json root = scene_json(scene);
    merge(root, patch);
    Scene result = scene_of_json(root, path);
    if (!patch.contains("about") && !same_subject(result, scene)) result.about.clear();
    return result;
}

}  // namespace normalscope

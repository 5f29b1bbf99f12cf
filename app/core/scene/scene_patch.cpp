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

Json changes(const Json& before, const Json& after) {
    Json patch = Json::object();
    for (const auto& [key, value] : after.items()) {
        const auto old = before.find(key);
        if (old != before.end() && *old == value) continue;
        // A surface is written whole: what one kind has, another lacks.
        const bool both = old != before.end() && old->is_object() && value.is_object() && key != "surface";
        patch[key] = both ? changes(*old, value) : value;
    }
    return patch;
}

}  // namespace

Json patch_between(const Scene& before, const Scene& after) {
    Json patch = changes(scene_json(before), scene_json(after));
    patch.erase("theme");
    if (!after.about.empty() && !same_subject(before, after)) patch["about"] = after.about;
    return patch;
}

Scene with_patch(const Scene& scene, const Json& patch, const JsonPath& path) {
    if (!patch.is_object()) fail_kind(path, "an object: the scene's keys that change", patch);
    Json root = scene_json(scene);
    merge(root, patch);
    Scene result = scene_of_json(root, path);
    if (!patch.contains("about") && !same_subject(result, scene)) result.about.clear();
    return result;
}

}  // namespace normalscope

#pragma once

#include "core/base/json_path.h"
#include "core/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

namespace normalscope {

/// The scene with some of its keys changed: `patch` is a scene's JSON of which only what changes is there. Objects are
/// changed key by key; arrays, and a surface of another kind, are replaced. `path` is where the patch stands within JSON
/// of other things. Throws JsonError.
Scene with_patch(const Scene& scene, const nlohmann::ordered_json& patch, const JsonPath& path);

/// What with_patch makes the second scene of the first by; the room's light is no part of it.
nlohmann::ordered_json patch_between(const Scene& before, const Scene& after);

}  // namespace normalscope

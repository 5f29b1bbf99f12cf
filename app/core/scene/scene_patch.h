#pragma once

#include "core/scene/scene.h"

#include <string_view>

namespace normalscope {

/// The scene with some of its keys changed: `patch` is a scene's JSON of which only what changes is written. Objects are
/// changed key by key; arrays, and a surface of another kind, are replaced. `source` names it in errors, as in
/// parse_scene. Throws InputError.
Scene with_patch(const Scene& scene, std::string_view patch, std::string_view source);

}  // namespace normalscope

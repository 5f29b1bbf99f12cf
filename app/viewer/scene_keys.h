#pragma once

#include "core/scene/scene.h"

#include <imgui.h>

namespace normalscope {

// What a key without Ctrl changes in the scene. False where it means nothing of the kind.

/// How one looks at the object: direction, theme.
bool press_view_key(Scene& scene, ImGuiKey key);
/// The object and what is said of it: rule, view, colours, ghost, stack.
bool press_object_key(Scene& scene, ImGuiKey key);

}  // namespace normalscope

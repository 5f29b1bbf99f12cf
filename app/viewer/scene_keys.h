#pragma once

#include "core/scene/scene.h"

#include <imgui.h>

#include <optional>

namespace normalscope {

/// The rule that a key chooses.
std::optional<Rule> rule_of(ImGuiKey key);

// What a key without Ctrl changes in the scene. False where it means nothing of the kind.

/// How one looks at the object: direction, theme.
bool press_view_key(Scene& scene, ImGuiKey key);
/// The object and what is said of it: view, colours, ghost, stack.
bool press_object_key(Scene& scene, ImGuiKey key);

}  // namespace normalscope

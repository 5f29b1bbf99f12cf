#pragma once

#include "viewer/key_press.h"

#include <string_view>

namespace normalscope {

/// A key of GLFW's, which names keys by where they are on a US keyboard, as Dear ImGui's key of what is `printed` on it,
/// such as "a" (empty: nothing, or GLFW does not know). Digits go by their place, since French keyboards, say, have them
/// only with Shift; but with Ctrl a minus there is a minus. What prints no sign that Dear ImGui has goes by its place, too.
/// ImGuiKey_None for keys that nobody needs.
ImGuiKey key_of(int glfw_key, std::string_view printed, ImGuiKeyChord modifiers);

/// GLFW's bits for Ctrl, Shift, Alt and Super as Dear ImGui's.
ImGuiKeyChord modifiers_of(int glfw_modifiers);

}  // namespace normalscope

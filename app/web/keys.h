#pragma once

#include <imgui.h>

#include <string_view>

namespace normalscope {

/// Of a browser's KeyboardEvent: what the key prints, or its name, and its place on the keyboard.
ImGuiKey key_of(std::string_view key, std::string_view code, ImGuiKeyChord modifiers);

/// Bits, as the page has them: 1 Ctrl, 2 Shift, 4 Alt, 8 Meta.
ImGuiKeyChord modifiers_of(int bits);

}  // namespace normalscope

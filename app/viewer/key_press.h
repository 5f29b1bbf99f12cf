#pragma once

#include <imgui.h>

namespace normalscope {

/// A key by what is printed on it, in the keyboard's own layout; digits by their place, since some layouts have them
/// only with Shift.
struct KeyPress {
    ImGuiKey key = ImGuiKey_None;
    ImGuiKeyChord modifiers = 0;
    bool repeated = false;  ///< it is being held

    bool control() const { return (modifiers & ImGuiMod_Ctrl) != 0; }
    bool shift() const { return (modifiers & ImGuiMod_Shift) != 0; }
    bool alt() const { return (modifiers & ImGuiMod_Alt) != 0; }
};

}  // namespace normalscope

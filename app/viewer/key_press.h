#pragma once

#include <imgui.h>

namespace normalscope {

/// A key by what is printed on it, in the keyboard's own layout; digits by their place, since some layouts have them
/// only with Shift.
struct KeyPress {
    ImGuiKey key = ImGuiKey_None;
    ImGuiKeyChord modifiers = 0;
    bool repeated = false;  ///< it is being held

    /// Ctrl; on a Mac, Cmd.
    bool control() const {
        return (modifiers & (ImGui::GetIO().ConfigMacOSXBehaviors ? ImGuiMod_Super : ImGuiMod_Ctrl)) != 0;
    }
    bool shift() const { return (modifiers & ImGuiMod_Shift) != 0; }
    bool alt() const { return (modifiers & ImGuiMod_Alt) != 0; }
    /// Ctrl, Shift, Alt, Cmd and such themselves, on either side.
    bool is_modifier() const { return key >= ImGuiKey_LeftCtrl && key <= ImGuiKey_RightSuper; }
};

/// The key that this sign is printed on; none for others.
ImGuiKey key_of_sign(char sign);

}  // namespace normalscope

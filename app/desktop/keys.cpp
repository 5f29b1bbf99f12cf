#include "desktop/keys.h"

#include "viewer/key_press.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace normalscope {

namespace {

// GLFW and Dear ImGui both have these one after the other.
ImGuiKey nth(ImGuiKey first, int n) { return static_cast<ImGuiKey>(first + n); }

ImGuiKey key_of_sign_at(int place) {
    switch (place) {
        case GLFW_KEY_APOSTROPHE: return ImGuiKey_Apostrophe;
        case GLFW_KEY_COMMA: return ImGuiKey_Comma;
        case GLFW_KEY_MINUS: return ImGuiKey_Minus;
        case GLFW_KEY_PERIOD: return ImGuiKey_Period;
        case GLFW_KEY_SLASH: return ImGuiKey_Slash;
        case GLFW_KEY_SEMICOLON: return ImGuiKey_Semicolon;
        case GLFW_KEY_EQUAL: return ImGuiKey_Equal;
        case GLFW_KEY_LEFT_BRACKET: return ImGuiKey_LeftBracket;
        case GLFW_KEY_BACKSLASH: return ImGuiKey_Backslash;
        case GLFW_KEY_RIGHT_BRACKET: return ImGuiKey_RightBracket;
        case GLFW_KEY_GRAVE_ACCENT: return ImGuiKey_GraveAccent;
        default: return ImGuiKey_None;
    }
}

// What prints nothing, or stands on the keypad.
ImGuiKey key_without_sign(int key) {
    switch (key) {
        case GLFW_KEY_TAB: return ImGuiKey_Tab;
        case GLFW_KEY_LEFT: return ImGuiKey_LeftArrow;
        case GLFW_KEY_RIGHT: return ImGuiKey_RightArrow;
        case GLFW_KEY_UP: return ImGuiKey_UpArrow;
        case GLFW_KEY_DOWN: return ImGuiKey_DownArrow;
        case GLFW_KEY_PAGE_UP: return ImGuiKey_PageUp;
        case GLFW_KEY_PAGE_DOWN: return ImGuiKey_PageDown;
        case GLFW_KEY_HOME: return ImGuiKey_Home;
        case GLFW_KEY_END: return ImGuiKey_End;
        case GLFW_KEY_INSERT: return ImGuiKey_Insert;
        case GLFW_KEY_DELETE: return ImGuiKey_Delete;
        case GLFW_KEY_BACKSPACE: return ImGuiKey_Backspace;
        case GLFW_KEY_SPACE: return ImGuiKey_Space;
        case GLFW_KEY_ENTER: return ImGuiKey_Enter;
        case GLFW_KEY_ESCAPE: return ImGuiKey_Escape;
        case GLFW_KEY_LEFT_CONTROL: return ImGuiKey_LeftCtrl;
        case GLFW_KEY_LEFT_SHIFT: return ImGuiKey_LeftShift;
        case GLFW_KEY_LEFT_ALT: return ImGuiKey_LeftAlt;
        case GLFW_KEY_LEFT_SUPER: return ImGuiKey_LeftSuper;
        case GLFW_KEY_RIGHT_CONTROL: return ImGuiKey_RightCtrl;
        case GLFW_KEY_RIGHT_SHIFT: return ImGuiKey_RightShift;
        case GLFW_KEY_RIGHT_ALT: return ImGuiKey_RightAlt;
        case GLFW_KEY_RIGHT_SUPER: return ImGuiKey_RightSuper;
        case GLFW_KEY_MENU: return ImGuiKey_Menu;
        case GLFW_KEY_KP_DECIMAL: return ImGuiKey_KeypadDecimal;
        case GLFW_KEY_KP_DIVIDE: return ImGuiKey_KeypadDivide;
        case GLFW_KEY_KP_MULTIPLY: return ImGuiKey_KeypadMultiply;
        case GLFW_KEY_KP_SUBTRACT: return ImGuiKey_KeypadSubtract;
        case GLFW_KEY_KP_ADD: return ImGuiKey_KeypadAdd;
        case GLFW_KEY_KP_ENTER: return ImGuiKey_KeypadEnter;
        case GLFW_KEY_KP_EQUAL: return ImGuiKey_KeypadEqual;
        default: return ImGuiKey_None;
    }
}

}  // namespace

ImGuiKey key_of(int key, std::string_view printed, ImGuiKeyChord modifiers) {
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return nth(ImGuiKey_F1, key - GLFW_KEY_F1);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return nth(ImGuiKey_Keypad0, key - GLFW_KEY_KP_0);
    if (const ImGuiKey named = key_without_sign(key); named != ImGuiKey_None) return named;
    const bool digit = key >= GLFW_KEY_0 && key <= GLFW_KEY_9;
    if (printed.size() == 1 && (!digit || (modifiers & (ImGuiMod_Ctrl | ImGuiMod_Super)) != 0))
        if (const ImGuiKey sign = key_of_sign(printed.front()); sign != ImGuiKey_None) return sign;
    if (digit) return nth(ImGuiKey_0, key - GLFW_KEY_0);
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return nth(ImGuiKey_A, key - GLFW_KEY_A);
    return key_of_sign_at(key);
}

ImGuiKeyChord modifiers_of(int glfw_modifiers) {
    ImGuiKeyChord held = 0;
    if (glfw_modifiers & GLFW_MOD_CONTROL) held |= ImGuiMod_Ctrl;
    if (glfw_modifiers & GLFW_MOD_SHIFT) held |= ImGuiMod_Shift;
    if (glfw_modifiers & GLFW_MOD_ALT) held |= ImGuiMod_Alt;
    if (glfw_modifiers & GLFW_MOD_SUPER) held |= ImGuiMod_Super;
    return held;
}

}  // namespace normalscope

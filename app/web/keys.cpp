#include "web/keys.h"

#include "viewer/key_press.h"

#include <algorithm>
#include <array>
#include <utility>

namespace normalscope {

namespace {

using Named = std::pair<std::string_view, ImGuiKey>;

// What prints nothing, or stands on the keypad, by its place.
constexpr std::array kNamed{Named{"Tab", ImGuiKey_Tab},
                            Named{"ArrowLeft", ImGuiKey_LeftArrow},
                            Named{"ArrowRight", ImGuiKey_RightArrow},
                            Named{"ArrowUp", ImGuiKey_UpArrow},
                            Named{"ArrowDown", ImGuiKey_DownArrow},
                            Named{"PageUp", ImGuiKey_PageUp},
                            Named{"PageDown", ImGuiKey_PageDown},
                            Named{"Home", ImGuiKey_Home},
                            Named{"End", ImGuiKey_End},
                            Named{"Insert", ImGuiKey_Insert},
                            Named{"Delete", ImGuiKey_Delete},
                            Named{"Backspace", ImGuiKey_Backspace},
                            Named{"Space", ImGuiKey_Space},
                            Named{"Enter", ImGuiKey_Enter},
                            Named{"Escape", ImGuiKey_Escape},
                            Named{"ControlLeft", ImGuiKey_LeftCtrl},
                            Named{"ShiftLeft", ImGuiKey_LeftShift},
                            Named{"AltLeft", ImGuiKey_LeftAlt},
                            Named{"MetaLeft", ImGuiKey_LeftSuper},
                            Named{"ControlRight", ImGuiKey_RightCtrl},
                            Named{"ShiftRight", ImGuiKey_RightShift},
                            Named{"AltRight", ImGuiKey_RightAlt},
                            Named{"MetaRight", ImGuiKey_RightSuper},
                            Named{"ContextMenu", ImGuiKey_Menu},
                            Named{"NumpadDecimal", ImGuiKey_KeypadDecimal},
                            Named{"NumpadDivide", ImGuiKey_KeypadDivide},
                            Named{"NumpadMultiply", ImGuiKey_KeypadMultiply},
                            Named{"NumpadSubtract", ImGuiKey_KeypadSubtract},
                            Named{"NumpadAdd", ImGuiKey_KeypadAdd},
                            Named{"NumpadEnter", ImGuiKey_KeypadEnter},
                            Named{"NumpadEqual", ImGuiKey_KeypadEqual}};

// A US keyboard's signs, for a layout that prints none of those there.
constexpr std::array kPlaces{
    std::pair{"Quote", '\''},       std::pair{"Comma", ','},       std::pair{"Minus", '-'},
    std::pair{"Period", '.'},       std::pair{"Slash", '/'},       std::pair{"Semicolon", ';'},
    std::pair{"Equal", '='},        std::pair{"BracketLeft", '['}, std::pair{"Backslash", '\\'},
    std::pair{"BracketRight", ']'}, std::pair{"Backquote", '`'}};

ImGuiKey nth(ImGuiKey first, int n) { return static_cast<ImGuiKey>(first + n); }

ImGuiKey named(std::string_view name) {
    const auto* const found = std::ranges::find(kNamed, name, &Named::first);
    return found == kNamed.end() ? ImGuiKey_None : found->second;
}

ImGuiKey function_key(std::string_view code) {
    if (code.size() < 2 || code.size() > 3 || code[0] != 'F') return ImGuiKey_None;
    int n = 0;
    for (const char c : code.substr(1)) n = c >= '0' && c <= '9' ? 10 * n + (c - '0') : 100;
    return n >= 1 && n <= 12 ? nth(ImGuiKey_F1, n - 1) : ImGuiKey_None;
}

}  // namespace

ImGuiKey key_of(std::string_view key, std::string_view code, ImGuiKeyChord modifiers) {
    if (const ImGuiKey function = function_key(code); function != ImGuiKey_None) return function;
    if (const ImGuiKey without_sign = named(code); without_sign != ImGuiKey_None) return without_sign;
    // A keyboard on a screen may tell nothing of places.
    if (const ImGuiKey without_place = named(key); without_place != ImGuiKey_None) return without_place;
    if (code.starts_with("Numpad") && code.size() == 7) return nth(ImGuiKey_Keypad0, code[6] - '0');
    const bool digit = code.starts_with("Digit") && code.size() == 6;
    if (key.size() == 1 && (!digit || (modifiers & ImGuiMod_Ctrl) != 0))
        if (const ImGuiKey sign = key_of_sign(key.front()); sign != ImGuiKey_None) return sign;
    if (digit) return nth(ImGuiKey_0, code[5] - '0');
    if (code.empty() && key.size() == 1 && key[0] >= '0' && key[0] <= '9') return nth(ImGuiKey_0, key[0] - '0');
    if (code.starts_with("Key") && code.size() == 4) return nth(ImGuiKey_A, code[3] - 'A');
    for (const auto& [place, sign] : kPlaces)
        if (code == place) return key_of_sign(sign);
    return ImGuiKey_None;
}

ImGuiKeyChord modifiers_of(int bits) {
    ImGuiKeyChord held = 0;
    if (bits & 1) held |= ImGuiMod_Ctrl;
    if (bits & 2) held |= ImGuiMod_Shift;
    if (bits & 4) held |= ImGuiMod_Alt;
    if (bits & 8) held |= ImGuiMod_Super;
    return held;
}

}  // namespace normalscope

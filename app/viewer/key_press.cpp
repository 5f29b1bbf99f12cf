#include "viewer/key_press.h"

#include <cctype>

namespace normalscope {

ImGuiKey key_of_sign(char sign) {
    if (std::isalpha(static_cast<unsigned char>(sign)))
        return static_cast<ImGuiKey>(ImGuiKey_A + std::tolower(static_cast<unsigned char>(sign)) - 'a');
    switch (sign) {
        case '\'': return ImGuiKey_Apostrophe;
        case ',': return ImGuiKey_Comma;
        case '-': return ImGuiKey_Minus;
        case '.': return ImGuiKey_Period;
        case '/': return ImGuiKey_Slash;
        case ';': return ImGuiKey_Semicolon;
        case '=':
        case '+': return ImGuiKey_Equal;  // a US keyboard has them on one key
        case '[': return ImGuiKey_LeftBracket;
        case '\\': return ImGuiKey_Backslash;
        case ']': return ImGuiKey_RightBracket;
        case '`': return ImGuiKey_GraveAccent;
        default: return ImGuiKey_None;
    }
}

}  // namespace normalscope

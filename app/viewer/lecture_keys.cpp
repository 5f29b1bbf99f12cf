#include "viewer/lecture_keys.h"

namespace normalscope {

std::optional<LectureKey> lecture_key(ImGuiKey key) {
    switch (key) {
        // The page keys are what presenters' remote controls send, and a full stop for a black screen.
        case ImGuiKey_PageDown: return LectureKey::Next;
        case ImGuiKey_PageUp: return LectureKey::Previous;
        case ImGuiKey_RightArrow: return LectureKey::Right;
        case ImGuiKey_LeftArrow: return LectureKey::Left;
        case ImGuiKey_UpArrow: return LectureKey::Up;
        case ImGuiKey_DownArrow: return LectureKey::Down;
        case ImGuiKey_Space:
        case ImGuiKey_Enter:
        case ImGuiKey_KeypadEnter: return LectureKey::Enter;
        case ImGuiKey_Slash: return LectureKey::Hint;  // the question mark's key
        case ImGuiKey_Home: return LectureKey::Again;
        case ImGuiKey_End: return LectureKey::Last;
        case ImGuiKey_Period:
        case ImGuiKey_B: return LectureKey::Black;
        case ImGuiKey_W: return LectureKey::White;
        case ImGuiKey_1:
        case ImGuiKey_Keypad1: return LectureKey::First;
        case ImGuiKey_2:
        case ImGuiKey_Keypad2: return LectureKey::Second;
        case ImGuiKey_3:
        case ImGuiKey_Keypad3: return LectureKey::Third;
        case ImGuiKey_4:
        case ImGuiKey_Keypad4: return LectureKey::Fourth;
        case ImGuiKey_5:
        case ImGuiKey_Keypad5: return LectureKey::Fifth;
        default: return std::nullopt;
    }
}

std::optional<LectureKey> lecture_key_while_asking(ImGuiKey key) {
    switch (key) {
        case ImGuiKey_A: return LectureKey::First;
        case ImGuiKey_B: return LectureKey::Second;
        case ImGuiKey_C: return LectureKey::Third;
        case ImGuiKey_D: return LectureKey::Fourth;
        case ImGuiKey_E: return LectureKey::Fifth;
        default: return lecture_key(key);
    }
}

}  // namespace normalscope

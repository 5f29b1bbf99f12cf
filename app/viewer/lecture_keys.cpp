#include "viewer/lecture_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace normalscope {

std::optional<LectureKey> lecture_key(int key) {
    switch (key) {
        // The page keys are what presenters' remote controls send, and a full stop for a black screen.
        case GLFW_KEY_PAGE_DOWN: return LectureKey::Next;
        case GLFW_KEY_PAGE_UP: return LectureKey::Previous;
        case GLFW_KEY_RIGHT: return LectureKey::Right;
        case GLFW_KEY_LEFT: return LectureKey::Left;
        case GLFW_KEY_UP: return LectureKey::Up;
        case GLFW_KEY_DOWN: return LectureKey::Down;
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER: return LectureKey::Enter;
        case GLFW_KEY_SLASH: return LectureKey::Hint;  // the question mark's key
        case GLFW_KEY_HOME: return LectureKey::Again;
        case GLFW_KEY_PERIOD:
        case GLFW_KEY_B: return LectureKey::Black;
        case GLFW_KEY_W: return LectureKey::White;
        case GLFW_KEY_1:
        case GLFW_KEY_KP_1: return LectureKey::First;
        case GLFW_KEY_2:
        case GLFW_KEY_KP_2: return LectureKey::Second;
        case GLFW_KEY_3:
        case GLFW_KEY_KP_3: return LectureKey::Third;
        case GLFW_KEY_4:
        case GLFW_KEY_KP_4: return LectureKey::Fourth;
        case GLFW_KEY_5:
        case GLFW_KEY_KP_5: return LectureKey::Fifth;
        default: return std::nullopt;
    }
}

}  // namespace normalscope

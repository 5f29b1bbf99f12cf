#include "desktop/cursors.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace normalscope {

Cursors::Cursors() {
    static_assert(kCount == ImGuiMouseCursor_COUNT);
    cursors_[ImGuiMouseCursor_TextInput] = glfwCreateStandardCursor(GLFW_IBEAM_CURSOR);
    cursors_[ImGuiMouseCursor_ResizeNS] = glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR);
    cursors_[ImGuiMouseCursor_ResizeEW] = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
    cursors_[ImGuiMouseCursor_Hand] = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
}

Cursors::~Cursors() {
    for (GLFWcursor* cursor : cursors_)
        if (cursor) glfwDestroyCursor(cursor);
}

void Cursors::show_in(GLFWwindow* window) const {
    const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
    glfwSetInputMode(window, GLFW_CURSOR, wanted == ImGuiMouseCursor_None ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
    if (wanted != ImGuiMouseCursor_None) glfwSetCursor(window, cursors_[static_cast<std::size_t>(wanted)]);
}

}  // namespace normalscope

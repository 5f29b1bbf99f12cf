#include "desktop/gui.h"

#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>  // InputEventsQueue

namespace normalscope {

Gui::Gui(GLFWwindow* window) : has_window_(window != nullptr) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // what is worth remembering is in the settings
    if (has_window_) ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    if (has_window_) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::layout(glm::ivec2 framebuffer, Theme theme, float scale, const std::function<void()>& content) {
    ImGuiIO& io = ImGui::GetIO();
    // The backend's NewFrame uploads a new font atlas only where it makes everything anew.
    if (interface.prepare(theme, scale)) ImGui_ImplOpenGL3_DestroyDeviceObjects();
    ImGui_ImplOpenGL3_NewFrame();
    if (has_window_)
        ImGui_ImplGlfw_NewFrame();
    else
        io.DeltaTime = 1.0f / 60.0f;
    // The interface counts in framebuffer pixels, as the picture does, so that text is sharp on every screen.
    io.DisplaySize = ImVec2(static_cast<float>(framebuffer.x), static_cast<float>(framebuffer.y));
    io.DisplayFramebufferScale = ImVec2(1.0f, 1.0f);
    ImGui::NewFrame();
    content();
    ImGui::Render();
}

void Gui::draw() const { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

bool Gui::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Gui::wants_keyboard() const { return ImGui::GetIO().WantTextInput; }
void Gui::finish_typing() { ImGui::ClearActiveID(); }
bool Gui::editing() const { return ImGui::IsAnyItemActive() || interface.playing(); }
bool Gui::moving() const {
    return interface.playing() || (ImGui::IsAnyItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left));
}
bool Gui::has_more_input() const { return !ImGui::GetCurrentContext()->InputEventsQueue.empty(); }

}  // namespace normalscope

#include "desktop/gl_gui.h"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

namespace normalscope {

GlGui::GlGui() { ImGui_ImplOpenGL3_Init("#version 330 core"); }
GlGui::~GlGui() { ImGui_ImplOpenGL3_Shutdown(); }

void GlGui::upload_fonts() {
    // The backend's NewFrame uploads a new font atlas only where it makes everything anew.
    ImGui_ImplOpenGL3_DestroyDeviceObjects();
    ImGui_ImplOpenGL3_NewFrame();
}

void GlGui::draw() const { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

}  // namespace normalscope

#include "ui/offscreen_gui.h"

#include "ui/kit/painter.h"

#include <imgui.h>

namespace normalscope {

OffscreenGui::OffscreenGui() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
}

OffscreenGui::~OffscreenGui() { ImGui::DestroyContext(); }

void OffscreenGui::layout(glm::ivec2 framebuffer, Theme theme, float scale, const std::function<void()>& content) {
    interface.prepare(theme, scale);
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = 1.0f / 60.0f;
    io.DisplaySize = ImVec2(static_cast<float>(framebuffer.x), static_cast<float>(framebuffer.y));
    io.DisplayFramebufferScale = ImVec2(1.0f, 1.0f);
    ImGui::NewFrame();
    content();
    ImGui::Render();
}

void OffscreenGui::paint(Image& image) const { normalscope::paint(*ImGui::GetDrawData(), image); }

}  // namespace normalscope

#include "ui/panel/drawer.h"

#include "ui/kit/widgets.h"
#include "ui/panel/panel_context.h"

#include <algorithm>

namespace normalscope {

namespace {

constexpr float kLeastBeside = 240.0f;  // of a picture beside the panel, in logical pixels
constexpr float kHandle = 40.0f;        // for a thumb
constexpr float kOpen = 0.5f;           // of the height

}  // namespace

bool is_drawer(const Look& look, glm::ivec2 framebuffer) {
    return framebuffer.y > framebuffer.x && static_cast<float>(framebuffer.x) < look.px(kPanelWidth + kLeastBeside);
}

int drawer_height(const Look& look, glm::ivec2 framebuffer, bool open) {
    const auto handle = static_cast<int>(look.px(kHandle));
    return open ? std::max(static_cast<int>(kOpen * static_cast<float>(framebuffer.y)), 2 * handle) : handle;
}

PixelRect panel_place(const Look& look, glm::ivec2 framebuffer) {
    if (!is_drawer(look, framebuffer)) return {{0, 0}, {static_cast<int>(look.px(kPanelWidth)), framebuffer.y}};
    const int height = drawer_height(look, framebuffer, true) - static_cast<int>(look.px(kHandle));
    return {{0, framebuffer.y - height}, {framebuffer.x, height}};
}

bool drawer_handle(const Look& look, const PixelRect& picture, bool open) {
    const ImVec2 low(static_cast<float>(picture.origin.x), static_cast<float>(picture.origin.y + picture.size.y));
    const ImVec2 size(static_cast<float>(picture.size.x), look.px(kHandle));
    begin_beside(picture, "##drawer", low, size, 0, true);
    const bool pressed = ImGui::Button(open ? "Close the controls" : "Controls", size);
    ImGui::End();
    return pressed;
}

}  // namespace normalscope

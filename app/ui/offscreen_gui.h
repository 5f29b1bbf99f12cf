#pragma once

#include "core/image/image.h"
#include "ui/interface.h"

#include <functional>

namespace normalscope {

/// Dear ImGui's context around an Interface that no window shows: drawn by the processor, into a picture.
class OffscreenGui {
public:
    OffscreenGui();
    ~OffscreenGui();
    OffscreenGui(const OffscreenGui&) = delete;
    OffscreenGui& operator=(const OffscreenGui&) = delete;

    /// One round of the interface: `content` runs between NewFrame and Render. Time advances by a fixed step, so that
    /// the same calls give the same picture.
    void layout(glm::ivec2 framebuffer, Theme theme, float scale, const std::function<void()>& content);
    /// Draws the last round into a picture of the framebuffer's size.
    void paint(Image& image) const;

    Interface interface;
};

}  // namespace normalscope

#pragma once

#include "gl/renderer.h"
#include "gl/target.h"
#include "viewer/host.h"

#include <cstddef>
#include <optional>

namespace normalscope {

/// What a viewer shows, drawn by GL: its frame, and Dear ImGui's last round over it. Both contexts are current, and outlive
/// this.
class Screen {
public:
    Screen();
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// Dear ImGui's font atlas is another: before its next round.
    void upload_fonts();
    /// `size`: the framebuffer's, in physical pixels.
    void draw(const Picture& picture, glm::ivec2 size);
    /// Copies what was drawn last to the framebuffer of the window or page.
    void show() const;
    /// The pixels of such a picture, with all of its samples, top row first. It is not shown.
    Image image_of(const Frame& frame, glm::ivec2 size);

private:
    /// What stands beside the frame in a target: while it stays the same, nothing of it is drawn again.
    struct Beside {
        const Target* target;
        PixelRect rect;  // of the frame
        Theme theme;
        std::size_t drawn;  // a hash of Dear ImGui's draws there
        bool operator==(const Beside&) const = default;
    };

    /// Anew where the window has another size than when it was asked for last.
    Target& target(glm::ivec2 size, bool rough);

    Renderer renderer_;
    std::optional<Target> target_, rough_target_;  // the latter while something moves that takes its time
    Target* last_ = nullptr;
    std::optional<Beside> beside_;
};

}  // namespace normalscope

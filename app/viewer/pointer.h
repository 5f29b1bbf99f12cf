#pragma once

#include "core/frame/axis_handles.h"
#include "core/frame/frame.h"
#include "core/frame/knobs.h"
#include "core/scene/scene.h"

#include <optional>

namespace normalscope {

struct PointerButton {
    bool left = true;
    bool shift = false;
};

/// The mouse on the picture: orbit, pan, zoom, the light, the axis handles and the other knobs, and a click that places the probe.
/// Pixels are the framebuffer's; `scale` is physical pixels per logical one.
class Pointer {
public:
    void press(const Scene& scene, const Frame& frame, PointerButton button, float scale);
    /// Knobs catch at numbers that one means (core/base/caught.h), unless the hand is `free`.
    enum class Hand { Caught, Free };
    void move(Scene& scene, const Frame& frame, glm::dvec2 pixel, float scale, Hand hand = Hand::Caught);
    void release(Scene& scene, const Frame& frame, float scale);
    void scroll(Scene& scene, double steps);

    /// A drag is under way.
    bool busy() const { return drag_ != Drag::None; }
    /// The last event was the wheel's: the zoom may go on.
    bool scrolled() const { return scrolled_; }
    /// The pointer points at nothing any more.
    void leave() {
        if (!busy()) hot_axis_.reset();
    }
    void end_scrolling() { scrolled_ = false; }
    /// The axis whose handle is dragged or pointed at.
    std::optional<int> hot_axis() const { return hot_axis_; }

private:
    enum class Drag { None, Orbit, Pan, Light, Handle, Knob, Probe };

    Drag drag_ = Drag::None;
    glm::dvec2 at_{0.0}, pressed_at_{0.0};
    bool moved_ = false;
    bool scrolled_ = false;
    bool uniform_ = false;
    std::optional<int> hot_axis_;
    std::optional<AxisHandle> handle_;  // as it was when grabbed
    double grab_offset_ = 0.0;
    std::optional<Knob> knob_;     // as it was when grabbed
    glm::dvec2 knob_offset_{0.0};  // from the pointer to it, in pixels
    Scene scene_at_press_;
};

}  // namespace normalscope

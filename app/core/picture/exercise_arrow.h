#pragma once

#include "core/frame/frame.h"

#include <optional>

namespace normalscope {

/// An arrow at the probe that somebody turns by hand. Dragging takes the half of all directions that faces the camera:
/// the tip is under the pointer, on a ball as large as the arrow is long, or on its rim.
struct ExerciseArrow {
    Vector<World> direction{{0.0, 1.0, 0.0}};  ///< unit

    /// Draws it, dark or light as the theme's text is, with `label` at its tip. Nothing without a probe.
    void add_to(Frame& frame, double arrow_length, double pixel_scale, const std::string& label) const;
    /// Whether the pixel is on it, or near.
    bool near(const Frame& frame, double arrow_length, double pixel_scale, glm::dvec2 pixel) const;
    void drag_to(const Frame& frame, double arrow_length, double pixel_scale, glm::dvec2 pixel);
    /// By keyboard: so many degrees to the right and up, as seen.
    void turn(const Frame& frame, double right, double up);
};

/// The object's outline and its normal at the probe, also where M's image hides them: both are drawn so much nearer to the
/// eye, and so much smaller, that they look the same and nothing stands before them. For what is as round as an ellipsoid.
void add_object_in_front(Frame& frame, double pixel_scale);

}  // namespace normalscope

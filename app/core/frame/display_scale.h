#pragma once

#include <glm/vec2.hpp>

namespace normalscope {

/// How large everything is drawn: as the desktop has it, as the user likes it, and in a lecture as the last row needs it.
struct DisplayScale {
    double interface = 1.0;  ///< the user's own factor, for low vision
    double presenter = 1.0;  ///< the same in presenter mode

    /// One step larger (+1) or smaller (−1), or back to 1 (0).
    void change(bool presenting, int steps);
    /// Physical pixels per logical one: as the desktop says, and more in a window larger than 1920 × 1080. In presenter mode
    /// the smallest words that are said, of 15 logical pixels, are 36 pixels high where the screen is 1080 high, and keep their share of
    /// it otherwise.
    float of(float desktop, glm::ivec2 framebuffer, bool presenting) const;
};

/// Words and lines keep their share of the picture, whatever its size; the panel must stay legible in a small one.
float usual_scale(glm::ivec2 size);
float usual_panel_scale(glm::ivec2 size);

}  // namespace normalscope

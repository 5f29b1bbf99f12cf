#pragma once

#include "core/frame/frame.h"
#include "ui/kit/style.h"

#include <glm/vec2.hpp>

#include <optional>

namespace normalscope {

/// What wants room beside the picture.
struct Claims {
    bool panel = true;
    bool lecture = false;                     ///< words below the picture
    bool presenting = false;                  ///< to a room, which is shown no panel
    bool exercising = false;                  ///< whose answer a panel or a tab would tell
    std::optional<float> tab = std::nullopt;  ///< the open one's width in logical pixels
};

/// What of it is shown, and what that leaves.
struct Arrangement {
    bool drawer = false;  ///< the panel is one below the picture, open or not
    bool panel = false;
    bool strip = false;  ///< the sentence above the picture
    int side = 0;        ///< how much of the width the open tab takes
    PixelRect picture;   ///< with a lecture's words still in it
};
Arrangement arrange(const Look& look, glm::ivec2 framebuffer, const Claims& claims);

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"
#include "ui/kit/style.h"

#include <string>

namespace normalscope {

/// Above the picture: what one sees, in a sentence, and what leads on from there.
struct SceneStrip {
    std::string sentence;
    bool plays = false;    ///< there is a stack to be played
    bool playing = false;  ///< it is
};
enum class StripPress { None, Play, Why, TryIt };

/// In physical pixels, for a width; whatever it says, so that the picture stays where it is.
float scene_strip_height(const Look& look, float width);

/// Above `picture`, as wide as it.
StripPress draw_scene_strip(const Look& look, const SceneStrip& strip, const PixelRect& picture);

}  // namespace normalscope

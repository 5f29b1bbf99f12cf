#pragma once

#include "core/scene/scene.h"
#include "ui/kit/style.h"

namespace normalscope {

/// Plays the stack from nothing to all of it.
struct StackPlayer {
    bool playing = false;
    double time = 0.0;      ///< in entries
    double position = 0.0;  ///< what was last shown: whoever sets another stops the playing
};

/// One frame onward, where it is playing.
void advance(StackPlayer& player, Scene& scene);

/// Play, a step back, a step on, and the slider of `Scene::stack_position`.
void player_controls(const Look& look, Scene& scene, StackPlayer& player);

}  // namespace normalscope

#pragma once

#include "core/scene/scene.h"
#include "ui/kit/style.h"

#include <string>

namespace normalscope {

/// Plays the stack from nothing to all of it.
struct StackPlayer {
    bool playing = false;
    double time = 0.0;      ///< in entries
    double position = 0.0;  ///< what was last shown: whoever sets another stops the playing
};

/// From nothing, or from where the scene is; where it is playing, it stops there.
void toggle(StackPlayer& player, Scene& scene);
/// Ends it at once, with all of the stack.
void finish(StackPlayer& player, Scene& scene);

/// What of the stack acts, in words.
std::string how_far(const Scene& scene);

/// One frame onward, where it is playing.
void advance(StackPlayer& player, Scene& scene);

/// Play, a step back, a step on, and the slider of `Scene::stack_position`.
void player_controls(const Look& look, Scene& scene, StackPlayer& player);

}  // namespace normalscope

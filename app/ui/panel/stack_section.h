#pragma once

#include "core/scene/scene.h"
#include "ui/kit/style.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace normalscope {

/// What the stack's section remembers from frame to frame.
struct StackMemory {
    bool lock_scale = false;           ///< the three factors keep their proportions
    glm::dvec3 factors_at_start{1.0};  ///< of the scale that is being dragged, so that a way through zero loses nothing
    std::vector<bool> folded;          ///< one an entry
};

/// The transforms in the order in which they act, and what M comes to.
/// `entries_of_m`: whether its matrix is unfolded.
void stack_section(const Look& look, Scene& scene, StackMemory& memory, bool& entries_of_m);

/// The sliders of one entry, as wide as given. The scene stays valid: every number finite, no axis of length zero.
void edit_entry(const Look& look, StackEntry& entry, float width, StackMemory& memory);
/// The entry's values in a few characters, such as "0.5, 2, 1".
std::string summary(const StackEntry& entry);
/// The same kind of entry, doing nothing.
StackEntry neutral(const StackEntry& entry);

}  // namespace normalscope

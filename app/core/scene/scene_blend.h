#pragma once

#include "core/scene/scene.h"

namespace normalscope {

/// A scene on the way from one (t = 0) to another (t = 1). Camera, light, lengths, the probe and the stack move evenly:
/// entries of the same kind directly; where the stacks differ in kind, the old entries go back to nothing before the new
/// ones set in. What cannot be in between, such as a rule, is the second scene's at once.
Scene blend(const Scene& from, const Scene& to, double t);

}  // namespace normalscope

#pragma once

#include "core/scene/scene.h"

#include <string>

namespace normalscope {

/// Opens the window on a scene and returns when it is closed. `file` is what the scene was read from, or empty.
/// Throws ContextError where there is no display.
void run_viewer(Scene scene, const std::string& file);

}  // namespace normalscope

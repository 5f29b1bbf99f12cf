#pragma once

#include "core/scene/scene.h"

#include <glm/vec2.hpp>

#include <string>

namespace normalscope {

/// The command line that captures what the window shows: `file` is what the scene was read from (or empty), `size` the
/// picture's, `scale` that of its words. It is right for the files as they are now.
std::string capture_command(const Scene& scene, const std::string& file, glm::ivec2 size, float scale);

}  // namespace normalscope

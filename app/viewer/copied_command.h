#pragma once

#include "core/scene/scene.h"
#include "viewer/document.h"

#include <glm/vec2.hpp>

#include <string>

namespace normalscope {

/// The command line that captures what the window shows: `origin` is where the scene comes from, `size` the picture's, `scale` that of its words. It is right for the files as they are now.
std::string capture_command(const Scene& scene, const Origin& origin, glm::ivec2 size, float scale);

}  // namespace normalscope

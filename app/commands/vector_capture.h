#pragma once

#include "cli/commands.h"
#include "core/scene/scene.h"

#include <string>

namespace normalscope {

/// The scene as SVG, placed as the picture of that size. No graphics context is needed.
std::string vector_capture(const Scene& scene, const PictureArguments& arguments);

}  // namespace normalscope

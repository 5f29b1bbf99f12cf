#pragma once

#include "cli/commands.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace normalscope {

struct VectorCapture {
    std::string svg;
    std::vector<std::string> notes;  ///< on the surface, and what no SVG holds
};

/// The scene as SVG, placed as the picture of that size. No graphics context is needed.
VectorCapture vector_capture(const Scene& scene, const PictureArguments& arguments);

}  // namespace normalscope

#pragma once

#include "core/frame.h"
#include "core/scene.h"

#include <string>

namespace normalscope {

/// What `--numbers` says of where the picture was drawn.
struct Drawn {
    std::string renderer;
    std::string context;
};

/// What the picture means, as JSON (DESIGN section 2): matrices as arrays of rows, null for what does not exist.
std::string numbers_text(const Scene& scene, const Frame& frame, const Drawn& drawn);

}  // namespace normalscope

#pragma once

#include "core/image.h"
#include "core/scene.h"
#include "platform/context.h"

#include <string>

namespace normalscope {

struct CaptureOptions {
    glm::ivec2 size{1280, 720};
    int samples = 4;
    ContextChoice context = ContextChoice::Auto;
    bool panel = false;    ///< the interface too
    std::string tab;       ///< the tab beside the picture, with the interface; empty: none
    bool numbers = false;  ///< fill Capture::numbers
};

struct Capture {
    Image image;
    std::string numbers;  ///< JSON text (DESIGN section 2)
};

/// A picture of the scene without a window. Throws InputError and ContextError.
Capture capture(const Scene& scene, const CaptureOptions& options);

}  // namespace normalscope

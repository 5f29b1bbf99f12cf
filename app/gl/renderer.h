#pragma once

#include "core/frame.h"

#include <memory>
#include <string>

namespace normalscope {

/// Draws a Frame into the bound framebuffer. Needs a current context, and must die before it.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// `framebuffer_height` turns the frame's top-left pixels into GL's.
    void draw(const Frame& frame, int framebuffer_height);

private:
    struct Resources;
    std::unique_ptr<Resources> resources_;
};

/// What GL calls itself, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
std::string renderer_name();
/// Such as "3.3 (Core Profile) Mesa 22.3.6".
std::string gl_version();

}  // namespace normalscope

#pragma once

#include "core/image.h"
#include "gl/objects.h"
#include "gl/programs.h"
#include "gl/vertex_data.h"

#include <glm/vec2.hpp>

namespace normalscope {

/// An off-screen picture: drawn with several samples a pixel, resolved to one, read back or shown.
class Target {
public:
    /// `samples` of 1 draws straight into the resolved picture; more than the driver has is cut to what it has.
    /// Throws ContextError where the driver cannot make a picture of this size.
    Target(glm::ivec2 size, int samples);

    glm::ivec2 size() const { return size_; }
    int samples() const { return samples_; }
    /// Draws go to the samples from now on.
    void bind() const;
    /// The samples' mean becomes the picture; draws go to the picture from now on, as the interface's must.
    void resolve() const;
    /// Copies the resolved picture to the window's framebuffer.
    void show() const;
    /// The resolved picture, top row first.
    Image read() const;

private:
    glm::ivec2 size_;
    int samples_;
    GlTexture color_;
    GlRenderbuffer depth_, resolved_color_;
    GlFramebuffer framebuffer_, resolved_;
    ResolveProgram resolve_program_;
    PaneVertices everywhere_;
};

}  // namespace normalscope

#pragma once

#include "gl/objects.h"

#include <glm/vec2.hpp>

namespace normalscope {

/// Several samples for each pixel of a picture, with their depths.
class Samples {
public:
    /// In one place, as GL has them; or each in a picture of its own, drawn one after the other, for what must be drawn to one
    /// of them alone where the driver cannot.
    enum class Layout { Together, Apart };
    static constexpr int kApart = 4;

    /// Throws ContextError where the driver cannot make as many.
    Samples(glm::ivec2 size, int count, Layout layout);

    /// In pixels.
    glm::ivec2 size() const { return size_; }
    Layout layout() const { return layout_; }
    /// How often all is to be drawn, and where in the framebuffer each time's pixels begin.
    int rounds() const { return layout_ == Layout::Apart ? kApart : 1; }
    glm::ivec2 corner(int round) const { return size_ * glm::ivec2(round & 1, round >> 1); }

    void bind() const;

    struct Colors {
        GLenum kind;  ///< GL_TEXTURE_2D_MULTISAMPLE with `count` samples, or GL_TEXTURE_2D
        GLuint texture;
        int count;  ///< of what is to be averaged for each pixel
    };
    /// The bound framebuffer may be another after that.
    Colors colors() const;

private:
    void make_together(int count);
    void make_apart();

    glm::ivec2 size_;
    Layout layout_;
    GlTexture color_;
    GlRenderbuffer depth_;
    GlFramebuffer framebuffer_;
#ifdef __EMSCRIPTEN__
    GlRenderbuffer unread_;  // there are no textures of several samples: these are averaged into color_
    GlFramebuffer averaged_;
#else
    int count_ = kApart;
#endif
};

/// Throws ContextError unless the bound framebuffer is complete.
void check_complete(glm::ivec2 size, int samples);
/// Samples of 0: one, and the buffer can be read with glReadPixels.
void make_storage(const GlRenderbuffer& buffer, GLenum format, glm::ivec2 size, int samples = 0);

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"
#include "core/image/image.h"
#include "gl/objects.h"
#include "gl/samples.h"

#include <glm/vec2.hpp>

#include <optional>

namespace normalscope {

/// An off-screen picture, and the samples that it is made from, of which there may be several a pixel. Pixels count from
/// the lower left, as GL's do.
class Target {
public:
    /// `samples` of 1 draws straight into the picture; more than the driver has is cut to what it has.
    /// Throws ContextError where the driver cannot make a picture of this size.
    Target(glm::ivec2 size, int samples);

    glm::ivec2 size() const { return size_; }
    int samples() const { return samples_; }

    /// Draws go to the picture from now on.
    void bind_picture() const;
    /// Draws go to new, clear samples of this box of the picture; its lower left corner is the samples' origin. Samples
    /// take much memory, and a driver on the processor long to clear them, so there are no more than must be.
    const Samples& bind_samples(const PixelRect& box, Samples::Layout layout);
    /// The box that has samples.
    const PixelRect& sampled() const { return sampled_; }
    /// There are some after bind_samples().
    const Samples& held() const { return *held_; }

    /// Waits until all is drawn.
    static void finish();
    /// Copies the picture to the window's framebuffer.
    void show() const;
    /// The picture, top row first.
    Image read() const;

private:
    glm::ivec2 size_;
    int samples_;
    GlRenderbuffer color_;
    std::optional<GlRenderbuffer> depth_;  // where the picture is drawn straight away
    GlFramebuffer picture_;
    PixelRect sampled_;
    std::optional<Samples> held_;
};

}  // namespace normalscope

#include "gl/target.h"

#include "core/error.h"

#include <algorithm>
#include <string>

namespace normalscope {

namespace {

void check_complete(glm::ivec2 size, int samples) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && glGetError() == GL_NO_ERROR) return;
    throw ContextError("this driver cannot draw " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                       " pixels with " + std::to_string(samples) + " samples; use a smaller size or fewer samples");
}

int supported(int samples) {
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    // resolve.frag adds up 2 or 4.
    const int fewer = std::clamp(samples, 1, std::clamp<int>(most, 1, 4));
    return fewer == 3 ? 2 : fewer;
}

}  // namespace

Target::Target(glm::ivec2 size, int samples) : size_(size), samples_(supported(samples)) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (size.x > largest || size.y > largest)
        throw ContextError("this driver draws at most " + std::to_string(largest) +
                           " pixels a side; use a smaller size");

    const auto storage = [&](const GlRenderbuffer& buffer, GLenum format, int count) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, count > 1 ? count : 0, format, size.x, size.y);
    };
    storage(depth_, GL_DEPTH_COMPONENT24, samples_);
    storage(resolved_color_, GL_RGBA8, 1);
    if (samples_ > 1) {
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, color_.id());
        glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, GL_RGBA8, size.x, size.y, GL_TRUE);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, color_.id(), 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
        check_complete(size, samples_);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolved_color_.id());
    if (samples_ == 1) glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    check_complete(size, samples_);
}

void Target::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, samples_ > 1 ? framebuffer_.id() : resolved_.id()); }

void Target::resolve() const {
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
    if (samples_ == 1) return;
    glViewport(0, 0, size_.x, size_.y);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, color_.id());
    resolve_program_.use();
    resolve_program_.count = samples_;
    everywhere_.draw();
}

void Target::show() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Image Target::read() const {
    Image image{size_,
                std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y))};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    // GL's first row is the lowest.
    const auto row = 4 * static_cast<std::ptrdiff_t>(size_.x);
    for (std::ptrdiff_t top = 0, bottom = size_.y - 1; top < bottom; ++top, --bottom)
        std::swap_ranges(image.rgba.begin() + top * row, image.rgba.begin() + (top + 1) * row,
                         image.rgba.begin() + bottom * row);
    return image;
}

}  // namespace normalscope

#include "gl/samples.h"

#include "core/base/error.h"

#include <string>

namespace normalscope {

namespace {

void make_texture(const GlTexture& texture, glm::ivec2 size) {
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

void check_complete(glm::ivec2 size, int samples) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && glGetError() == GL_NO_ERROR) return;
    throw ContextError("this driver cannot draw " + std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels" +
                       (samples > 1 ? " with " + std::to_string(samples) + " samples" : "") +
                       ", or is out of memory; use a smaller size or fewer samples");
}

void make_storage(const GlRenderbuffer& buffer, GLenum format, glm::ivec2 size, int samples) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.x, size.y);
}

Samples::Samples(glm::ivec2 size, int count, Layout layout) : size_(size), layout_(layout) {
    layout_ == Layout::Apart ? make_apart() : make_together(count);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    check_complete(size, count);
}

void Samples::make_apart() {
    make_storage(depth_, GL_DEPTH_COMPONENT24, 2 * size_);
    make_texture(color_, 2 * size_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.id(), 0);
}

void Samples::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id()); }

#ifdef __EMSCRIPTEN__

void Samples::make_together(int count) {
    make_storage(depth_, GL_DEPTH_COMPONENT24, size_, count);
    make_storage(unread_, GL_RGBA8, size_, count);
    make_texture(color_, size_);
    glBindFramebuffer(GL_FRAMEBUFFER, averaged_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.id(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, unread_.id());
}

Samples::Colors Samples::colors() const {
    if (layout_ == Layout::Apart) return {GL_TEXTURE_2D, color_.id(), kApart};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, averaged_.id());
    const bool cut = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    if (cut) glEnable(GL_SCISSOR_TEST);
    return {GL_TEXTURE_2D, color_.id(), 1};
}

#else

void Samples::make_together(int count) {
    count_ = count;
    make_storage(depth_, GL_DEPTH_COMPONENT24, size_, count);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, color_.id());
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, count, GL_RGBA8, size_.x, size_.y, GL_TRUE);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, color_.id(), 0);
}

Samples::Colors Samples::colors() const {
    if (layout_ == Layout::Apart) return {GL_TEXTURE_2D, color_.id(), kApart};
    return {GL_TEXTURE_2D_MULTISAMPLE, color_.id(), count_};
}

#endif

}  // namespace normalscope

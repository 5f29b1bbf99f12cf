#include "gl/target.h"

#include "core/base/error.h"
#include "gl/driver.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <string>

namespace normalscope {

namespace {

int supported(int samples) {
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
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
    make_storage(color_, GL_RGBA8, size);
    glBindFramebuffer(GL_FRAMEBUFFER, picture_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.id());
    if (samples_ == 1) {
        make_storage(depth_.emplace(), GL_DEPTH_COMPONENT24, size);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_->id());
    }
    check_complete(size, 1);
}

void Target::bind_picture() const { glBindFramebuffer(GL_FRAMEBUFFER, picture_.id()); }

const Samples& Target::bind_samples(const PixelRect& box, Samples::Layout layout) {
    sampled_ = box;
    const glm::ivec2 wanted = glm::max(box.size, 1);
    if (!held_ || held_->layout() != layout || glm::any(glm::lessThan(held_->size(), wanted))) {
        // A picture by itself gets what it needs; where one follows the other, some room to grow.
        const glm::ivec2 room = held_ ? glm::max(wanted + wanted / 4, held_->size()) : wanted;
        held_.reset();
        held_.emplace(glm::min((room + 63) / 64 * 64, size_), samples_, layout);
    }
    held_->bind();
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return *held_;
}

void Target::finish() { wait_for_pixels(); }

void Target::show() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Image Target::read() const {
    Image image{size_,
                std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y))};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.id());
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

#pragma once

#include "core/base/error.h"
#include "platform/offscreen_context.h"

#include <glad/gl.h>
#include <gtest/gtest.h>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <vector>

namespace normalscope {

/// One context for all tests of a process: making one takes longer than most of them.
inline void need_context() {
    static const std::unique_ptr<Context> context = make_offscreen_context({});
    context->make_current();
}

/// What is in a texture of floats, lowest row first.
inline std::vector<glm::vec4> texels(GLuint texture, glm::ivec2 size) {
    std::vector<glm::vec4> result(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, result.data());
    return result;
}

}  // namespace normalscope

#pragma once

#include "gl/gl.h"

#include <utility>

namespace normalscope {

/// The sole owner of a GL object; it must die before its context.
template <class Kind>
class GlObject {
public:
    GlObject() { Kind::create(&id_); }
    ~GlObject() {
        if (id_) Kind::destroy(&id_);
    }
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0u)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
};

struct BufferKind {
    static void create(GLuint* id) { glGenBuffers(1, id); }
    static void destroy(const GLuint* id) { glDeleteBuffers(1, id); }
};
struct VertexArrayKind {
    static void create(GLuint* id) { glGenVertexArrays(1, id); }
    static void destroy(const GLuint* id) { glDeleteVertexArrays(1, id); }
};
struct FramebufferKind {
    static void create(GLuint* id) { glGenFramebuffers(1, id); }
    static void destroy(const GLuint* id) { glDeleteFramebuffers(1, id); }
};
struct RenderbufferKind {
    static void create(GLuint* id) { glGenRenderbuffers(1, id); }
    static void destroy(const GLuint* id) { glDeleteRenderbuffers(1, id); }
};

struct TextureKind {
    static void create(GLuint* id) { glGenTextures(1, id); }
    static void destroy(const GLuint* id) { glDeleteTextures(1, id); }
};

struct QueryKind {
    static void create(GLuint* id) { glGenQueries(1, id); }
    static void destroy(const GLuint* id) { glDeleteQueries(1, id); }
};

using GlBuffer = GlObject<BufferKind>;
using GlQuery = GlObject<QueryKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlFramebuffer = GlObject<FramebufferKind>;
using GlRenderbuffer = GlObject<RenderbufferKind>;
using GlTexture = GlObject<TextureKind>;

}  // namespace normalscope

#include "gl/version.h"

#include "gl/gl.h"

namespace normalscope {

namespace {

std::string gl_string(GLenum which) {
    const GLubyte* text = glGetString(which);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

std::string renderer_name() { return gl_string(GL_RENDERER); }
std::string gl_version() { return gl_string(GL_VERSION); }

}  // namespace normalscope

#include "platform/gl_debug.h"

#include <glad/gl.h>

#include <cstdio>
#include <cstdlib>

namespace normalscope {

namespace {

bool of_consequence(GLenum type, GLenum severity) {
    return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
           severity == GL_DEBUG_SEVERITY_HIGH;
}

void GLAD_API_PTR on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text, const void*) {
    if (!of_consequence(type, severity)) return;
    // A driver calls this from its own C code, through which nothing may be thrown.
    std::fprintf(stderr, "normalscope: OpenGL: %s\n", text);
    std::abort();
}

}  // namespace

void watch_for_gl_errors() {
    if (!std::getenv("NORMALSCOPE_GL_DEBUG") || !GLAD_GL_KHR_debug) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // on the thread and at the call that is to blame
    glDebugMessageCallback(on_message, nullptr);
}

}  // namespace normalscope

#pragma once

#include "gl/gl.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// A GL program from two embedded shader files, each behind the shared preamble and with what it includes. Derived
/// classes name its uniforms once, as typed slots. Throws std::runtime_error with the file's name and the compiler's log.
class Program {
public:
    /// `define` is a preprocessor symbol for both stages, or empty; `formula` is what the fragment file
    /// includes as formula.glsl.
    Program(std::string_view vertex_file, std::string_view fragment_file, std::string_view define = {},
            std::string_view formula = "");
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { glUseProgram(id_); }

    /// A uniform of a given type, which may be called carried_ and its name (shaders/trace.vert); setting one that the
    /// compiler has optimised away does nothing.
    template <class T>
    class Slot {
    public:
        Slot(const Program& program, const char* name) : location_(location(program.id_, name)) {}
        void operator=(const T& value) const { set(location_, value); }

    private:
        GLint location_;
    };

protected:
    static GLint location(GLuint program, const std::string& name) {
        const GLint plain = glGetUniformLocation(program, name.c_str());
        return plain >= 0 ? plain : glGetUniformLocation(program, ("carried_" + name).c_str());
    }
    static void set(GLint at, int v) { glUniform1i(at, v); }
    static void set(GLint at, float v) { glUniform1f(at, v); }
    static void set(GLint at, const glm::ivec2& v) { glUniform2i(at, v.x, v.y); }
    static void set(GLint at, const glm::vec2& v) { glUniform2f(at, v.x, v.y); }
    static void set(GLint at, const glm::vec3& v) { glUniform3f(at, v.x, v.y, v.z); }
    static void set(GLint at, const glm::vec4& v) { glUniform4f(at, v.x, v.y, v.z, v.w); }
    static void set(GLint at, const glm::mat3& v) { glUniformMatrix3fv(at, 1, GL_FALSE, &v[0].x); }
    static void set(GLint at, const glm::mat4& v) { glUniformMatrix4fv(at, 1, GL_FALSE, &v[0].x); }
    static void set(GLint at, std::span<const glm::vec3> v) {
        glUniform3fv(at, static_cast<GLsizei>(v.size()), &v[0].x);
    }

private:
    GLuint id_ = 0;
};

}  // namespace normalscope

#include "gl/program.h"

#include <embedded.h>

#include <array>
#include <stdexcept>
#include <string>

namespace normalscope {

namespace {

void append_stage(GLuint program, GLenum stage, std::string_view file, std::string_view define,
                  std::string_view generated = "") {
    const std::string defines = define.empty() ? "" : "#define " + std::string(define) + "\n";
    const std::array<std::string_view, 5> parts{Program::file("preamble.glsl"), defines, generated, "#line 1\n",
                                                Program::file(file)};
    std::array<const GLchar*, 5> texts{};
    std::array<GLint, 5> lengths{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        texts[i] = parts[i].data();
        lengths[i] = static_cast<GLint>(parts[i].size());
    }
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, static_cast<GLsizei>(parts.size()), texts.data(), lengths.data());
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        std::array<GLchar, 2000> log{};
        glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
        glDeleteShader(shader);
        throw std::runtime_error("shaders/" + std::string(file) + ": does not compile: " + log.data());
    }
    glAttachShader(program, shader);
    glDeleteShader(shader);  // lives as long as the program has it attached
}

}  // namespace

std::string_view Program::file(std::string_view name) {
    const auto text = embedded::file("shaders/" + std::string(name));
    if (!text) throw std::runtime_error("shaders/" + std::string(name) + ": is not part of this program");
    return *text;
}

Program::Program(std::string_view vertex_file, std::string_view fragment_file, std::string_view define,
                 std::string_view generated)
    : id_(glCreateProgram()) {
    try {
        append_stage(id_, GL_VERTEX_SHADER, vertex_file, define);
        append_stage(id_, GL_FRAGMENT_SHADER, fragment_file, define, generated);
        glLinkProgram(id_);
        GLint linked = GL_FALSE;
        glGetProgramiv(id_, GL_LINK_STATUS, &linked);
        if (!linked) {
            std::array<GLchar, 2000> log{};
            glGetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
            throw std::runtime_error("shaders/" + std::string(vertex_file) + " and " + std::string(fragment_file) +
                                     ": do not link: " + log.data());
        }
    } catch (...) {
        glDeleteProgram(id_);
        throw;
    }
}

Program::~Program() { glDeleteProgram(id_); }

}  // namespace normalscope

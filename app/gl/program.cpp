#include "gl/program.h"

#include <embedded.h>

#include <array>
#include <stdexcept>
#include <string>

namespace normalscope {

namespace {

std::string_view source_of(std::string_view file) {
    const auto text = embedded::file("shaders/" + std::string(file));
    if (!text) throw std::runtime_error("shaders/" + std::string(file) + ": is not part of this program");
    return *text;
}

void append_stage(GLuint program, GLenum stage, std::string_view file, std::string_view define) {
    const std::string defines = define.empty() ? "" : "#define " + std::string(define) + "\n";
    const std::array<std::string_view, 4> parts{source_of("preamble.glsl"), defines, "#line 1\n", source_of(file)};
    std::array<const GLchar*, 4> texts{};
    std::array<GLint, 4> lengths{};
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

Program::Program(std::string_view vertex_file, std::string_view fragment_file, std::string_view define)
    : id_(glCreateProgram()) {
    try {
        append_stage(id_, GL_VERTEX_SHADER, vertex_file, define);
        append_stage(id_, GL_FRAGMENT_SHADER, fragment_file, define);
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

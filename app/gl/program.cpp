#include "gl/program.h"

#include <embedded.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace normalscope {

namespace {

std::string_view embedded_shader(std::string_view name) {
    const auto text = embedded::file("shaders/" + std::string(name));
    if (!text) throw std::runtime_error("shaders/" + std::string(name) + ": is not part of this program");
    return *text;
}

#ifdef __EMSCRIPTEN__
constexpr std::string_view kPreamble = "preamble_es.glsl";
#else
constexpr std::string_view kPreamble = "preamble.glsl";
#endif
constexpr std::string_view kInclude = "#include \"";

// A shader file, and in it, at their lines, the files that it includes; formula.glsl is what was made.
void append_file(std::vector<std::string_view>& parts, std::string_view name, std::string_view formula) {
    std::string_view rest = embedded_shader(name);
    parts.push_back("#line 1\n");
    for (std::size_t at = rest.find(kInclude); at != rest.npos; at = rest.find(kInclude)) {
        parts.push_back(rest.substr(0, at));
        rest.remove_prefix(at + kInclude.size());
        const std::string_view included = rest.substr(0, rest.find('"'));
        parts.push_back(included == "formula.glsl" ? formula : embedded_shader(included));
        rest.remove_prefix(rest.find('\n') + 1);
    }
    parts.push_back(rest);
}

void append_stage(GLuint program, GLenum stage, std::string_view file, std::string_view define,
                  std::string_view formula = "") {
    const std::string defines = define.empty() ? "" : "#define " + std::string(define) + "\n";
    std::vector<std::string_view> parts{embedded_shader(kPreamble), defines};
    append_file(parts, file, formula);
    std::vector<const GLchar*> texts;
    std::vector<GLint> lengths;
    for (const std::string_view part : parts) {
        texts.push_back(part.data());
        lengths.push_back(static_cast<GLint>(part.size()));
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

Program::Program(std::string_view vertex_file, std::string_view fragment_file, std::string_view define,
                 std::string_view formula)
    : id_(glCreateProgram()) {
    try {
        append_stage(id_, GL_VERTEX_SHADER, vertex_file, define);
        append_stage(id_, GL_FRAGMENT_SHADER, fragment_file, define, formula);
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

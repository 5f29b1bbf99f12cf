// f and ∇f as the graphics processor computes them, against the processor's doubles, at thousands of points.

#include "core/program/compile.h"
#include "support.h"

#include "random_formula.h"

#include "core/formula/formula.h"
#include "core/program/evaluate.h"
#include "core/program/glsl.h"
#include "core/surface/implicit_surface.h"
#include "gl/objects.h"
#include "gl/vertex_data.h"

#include <embedded.h>

#include <glm/geometric.hpp>

#include <string>

namespace normalscope::formulas {
namespace {

constexpr int kPoints = 2048;

GLuint shader(GLenum stage, const std::string& text) {
    const GLuint id = glCreateShader(stage);
    const char* source = text.c_str();
    glShaderSource(id, 1, &source, nullptr);
    glCompileShader(id);
    GLint compiled = 0;
    glGetShaderiv(id, GL_COMPILE_STATUS, &compiled);
    std::string log(1000, '\0');
    if (!compiled) glGetShaderInfoLog(id, 1000, nullptr, log.data());
    EXPECT_TRUE(compiled) << log << text;
    return id;
}

/// xyz ∇f and w f at each point, or w alone NaN-free and ∇f 0 where the shader says that f has no value.
std::vector<glm::vec4> evaluated(const Glsl& glsl, const std::vector<glm::vec4>& points) {
    const std::string head = "#version 330 core\nprecision highp float;\nprecision highp int;\n";
    const GLuint program = glCreateProgram();
    glAttachShader(program, shader(GL_VERTEX_SHADER, head + "layout(location = 0) in vec2 corner;\n"
                                                            "void main() { gl_Position = vec4(corner, 0.0, 1.0); }"));
    glAttachShader(program, shader(GL_FRAGMENT_SHADER,
                                   head + std::string(*embedded::file("shaders/functions.glsl")) + glsl.source +
                                       "uniform sampler2D points;\nout vec4 result;\n"
                                       "void main() {\n"
                                       "    vec3 p = texelFetch(points, ivec2(gl_FragCoord.xy), 0).xyz;\n"
                                       "    result = is_defined(p) ? vec4(gradient(p), f(p)) : vec4(0, 0, 0, 1e35);\n"
                                       "}\n"));
    glLinkProgram(program);
    std::array<GlTexture, 2> textures;
    for (std::size_t k = 0; k < 2; ++k) {
        glBindTexture(GL_TEXTURE_2D, textures[k].id());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kPoints, 1, 0, GL_RGBA, GL_FLOAT, k == 0 ? points.data() : nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    const GlFramebuffer framebuffer;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[1].id(), 0);
    glViewport(0, 0, kPoints, 1);
    glBindTexture(GL_TEXTURE_2D, textures[0].id());
    glUseProgram(program);
    PaneVertices().draw();
    glDeleteProgram(program);
    return texels(textures[1].id(), {kPoints, 1});
}

// How far f and ∇f may be off in floats: what bounds over a box of a few roundings around the point allow.
void expect_agreement(const std::string& text, Random& random) {
    const Formula formula = formulas::read(text);
    const Program program = compile(formula.graph, formula.f, kAllOne);
    std::vector<glm::vec4> points(kPoints);
    for (glm::vec4& p : points)
        p = {static_cast<float>(random.uniform(-2, 2)), static_cast<float>(random.uniform(-2, 2)),
             static_cast<float>(random.uniform(-2, 2)), 0.0f};
    const std::vector<glm::vec4> found = evaluated(to_glsl(compile(formula.graph, formula.f, std::nullopt)), points);

    for (int i = 0; i < kPoints; ++i) {
        const glm::vec4& gpu = found[static_cast<std::size_t>(i)];
        for (int k = 0; k < 4; ++k) ASSERT_FALSE(std::isnan(gpu[k])) << text;
        const glm::dvec3 p(points[static_cast<std::size_t>(i)]);
        const glm::dvec3 reach = 3e-6 * (glm::abs(p) + 0.1);
        const IntervalSample bounds = sample(program, Box{p - reach, p + reach});
        // Beside a pole or a branch floats may come out on the other side.
        if (bounds.value.defined != Interval::Defined::Everywhere || !(bounds.value.width() < 1e-2)) continue;
        const double size = std::max({1.0, std::abs(bounds.value.low), std::abs(bounds.value.high)});
        if (size > 1e4) continue;

        const double slack = 2e-5 * size + 3.0 * bounds.value.width();
        ASSERT_GE(gpu.w, bounds.value.low - slack) << text << " at " << p.x << " " << p.y << " " << p.z;
        ASSERT_LE(gpu.w, bounds.value.high + slack) << text << " at " << p.x << " " << p.y << " " << p.z;
        for (int k = 0; k < 3; ++k) {
            const Interval& g = bounds.gradient[static_cast<std::size_t>(k)];
            const double steep = std::max({1.0, std::abs(g.low), std::abs(g.high)});
            if (g.defined != Interval::Defined::Everywhere || !(g.width() < 1e-2 * steep) || steep > 1e4) continue;
            const double room = 1e-3 * steep + 3.0 * g.width();
            ASSERT_GE(gpu[k], g.low - room) << text << " ∂" << "xyz"[k] << " at " << p.x << " " << p.y << " " << p.z;
            ASSERT_LE(gpu[k], g.high + room) << text << " ∂" << "xyz"[k] << " at " << p.x << " " << p.y << " " << p.z;
        }
    }
}

TEST(Glsl, KnownFormulasAgreeWithTheProcessor) {
    need_context();
    Random random(7);
    for (const char* text :
         {"x^2+y^2+z^2-1", "(x^2+9/4y^2+z^2-1)^3-x^2z^3-9/80y^2z^3", "sin(3x)cos(3y)+sin(3y)cos(3z)+sin(3z)cos(3x)",
          "|x|^0.5+|y|^0.5+|z|^0.5-1", "x^y-z", "x^(1/3)+y^(2/3)+z", "log(x^2+1)+atan(y)-asin(z/3)", "1/x+1/(y-z)",
          "min(x, max(y, z))-0.3", "exp(-x^2)-y z", "x^17+y^-2-z^9", "tan(x)+acos(y/2)", "abs(x-y)-sqrt(z+2)",
          "floor(3x)+mod(y, z^2+1)-heaviside(z)", "atan2(y, x)-z", "cbrt(x)+log10(y^2+1)+hypot(x, z)",
          "sinh(x)+cosh(2y)-tanh(100z)", "asinh(1e6x)+acosh(y+1)-atanh(z)", "asinh(1e25x)-acosh(1e25y)"})
        expect_agreement(text, random);
}

TEST(Glsl, RandomFormulasAgreeWithTheProcessor) {
    need_context();
    Random random(11);
    for (int i = 0; i < 60; ++i) {
        const std::string text = random_formula(random, {}, 4);
        try {
            (void)read(text);
        } catch (const InputError&) {
            continue;  // such as sqrt(-1)
        }
        expect_agreement(text, random);
    }
}

}  // namespace
}  // namespace normalscope::formulas

#include "gl/driver.h"

#include "gl/gl.h"

#include <array>
#include <string_view>

#ifdef __EMSCRIPTEN__
#include <emscripten/html5_webgl.h>
#endif

namespace normalscope {

namespace {

int sample_count() {
    GLint count = 0;
    glGetIntegerv(GL_SAMPLES, &count);
    return count;
}

#ifdef __EMSCRIPTEN__
// In this context: after a loss it is another.
bool has(const char* extension) {
    return emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), extension);
}
#endif

}  // namespace

std::span<const glm::vec2> usual_places() {
    static constexpr std::array<glm::vec2, 4> kPlaces{
        {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}}};
    return kPlaces;
}

#ifdef __EMSCRIPTEN__

std::vector<glm::vec2> sample_places() {
    if (sample_count() != 4 || !masks_samples()) return {};
    return {usual_places().begin(), usual_places().end()};
}
bool masks_samples() { return has("OES_sample_variables"); }
void mask_samples(int) {}
void unmask_samples() {}

bool draws_floats() { return has("EXT_color_buffer_float"); }
bool blends_floats() { return false; }
bool answers_at_once() { return false; }
bool has_doubles() { return false; }
bool carries_much() { return false; }

// A page's glFinish returns at once.
void wait_for_pixels() {
    std::array<GLubyte, 4> pixel{};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
}

#else

std::vector<glm::vec2> sample_places() {
    const int count = sample_count();
    std::vector<glm::vec2> places(count > 1 ? static_cast<std::size_t>(count) : 0);
    for (std::size_t k = 0; k < places.size(); ++k)
        glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(k), &places[k].x);
    return places;
}
bool masks_samples() { return true; }
void mask_samples(int bits) {
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, static_cast<GLbitfield>(bits));
}
void unmask_samples() {
    glSampleMaski(0, ~0u);
    glDisable(GL_SAMPLE_MASK);
}

bool draws_floats() { return true; }
bool blends_floats() { return true; }
bool answers_at_once() { return true; }

bool has_doubles() {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i)
        if (reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)) == std::string_view("GL_ARB_gpu_shader_fp64"))
            return true;
    return false;
}

bool carries_much() {
    GLint numbers = 0;
    glGetIntegerv(GL_MAX_VARYING_COMPONENTS, &numbers);
    return numbers >= 100;
}

void wait_for_pixels() { glFinish(); }

#endif

}  // namespace normalscope

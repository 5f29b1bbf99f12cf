#include "platform/hidden_window_context.h"

#include "core/base/error.h"
#include "platform/gl_debug.h"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string>

namespace normalscope {

namespace {

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "GLFW gives no reason";
}

class HiddenWindow final : public Context {
public:
    HiddenWindow() {
        if (!glfwInit()) throw ContextError(last_error());
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        window_ = glfwCreateWindow(kSide, kSide, "Normalscope", nullptr, nullptr);
        if (!window_) throw ContextError(last_error());
    }
    // GLFW is not ended: it would unload system libraries in which a thread may still run.
    ~HiddenWindow() override { glfwDestroyWindow(window_); }
    HiddenWindow(const HiddenWindow&) = delete;
    HiddenWindow& operator=(const HiddenWindow&) = delete;

    void make_current() override {
        glfwMakeContextCurrent(window_);
        if (!gladLoadGL(glfwGetProcAddress))
            throw ContextError("the hidden window's OpenGL 3.3 context cannot be used");
        watch_for_gl_errors();
    }
    std::string_view name() const override { return "hidden-window"; }

private:
    static constexpr int kSide = 16;
    GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> make_hidden_window_context() { return std::make_unique<HiddenWindow>(); }

}  // namespace normalscope

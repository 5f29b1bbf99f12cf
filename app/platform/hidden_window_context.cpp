#include "platform/hidden_window_context.h"

#include "core/base/error.h"
#include "platform/gl_debug.h"
#include "platform/glfw_start.h"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace normalscope {

namespace {

class HiddenWindow final : public Context {
public:
    HiddenWindow() {
        start_glfw(GlfwFor::HiddenWindow);
        ask_for_opengl();
        window_ = glfwCreateWindow(kSide, kSide, "Normalscope", nullptr, nullptr);
        if (!window_) throw ContextError(glfw_error());
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

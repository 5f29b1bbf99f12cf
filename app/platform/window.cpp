#include "platform/window.h"

#include "core/base/error.h"
#include "platform/gl_debug.h"
#include "platform/glfw_start.h"
#include "platform/mesa_settings.h"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE  // GL's declarations come from glad
#include <GLFW/glfw3.h>
#include <glm/common.hpp>

#include <algorithm>
#include <span>
#include <string>

namespace normalscope {

namespace {

constexpr glm::ivec2 kFirstSize{1280, 800};          // logical pixels
constexpr const char* kDesktopName = "normalscope";  // of normalscope.desktop, by which desktops find the window's icon

// There a window's size is in logical pixels, while a monitor's is in physical ones, and nobody learns where it stands.
bool on_wayland() {
#ifdef GLFW_PLATFORM
    return glfwGetPlatform() == GLFW_PLATFORM_WAYLAND;
#else
    return false;
#endif
}

// There all sizes are in logical pixels.
bool on_a_mac() {
#ifdef GLFW_PLATFORM
    return glfwGetPlatform() == GLFW_PLATFORM_COCOA;
#else
    return false;
#endif
}

std::span<GLFWmonitor*> monitors() {
    int count = 0;
    GLFWmonitor** const list = glfwGetMonitors(&count);
    return {list, static_cast<std::size_t>(count)};
}

std::string name_of(GLFWmonitor* monitor) {
    const char* name = glfwGetMonitorName(monitor);
    return name ? name : "";
}

// Null where it is not connected any more.
GLFWmonitor* monitor_named(const std::string& name) {
    for (GLFWmonitor* monitor : monitors())
        if (!name.empty() && name_of(monitor) == name) return monitor;
    return nullptr;
}

// The monitor that most of the window lies on.
GLFWmonitor* monitor_of(const WindowPlace& place) {
    GLFWmonitor* best = glfwGetPrimaryMonitor();
    int best_area = 0;
    const glm::ivec2 size = place.size.value_or(kFirstSize);
    for (GLFWmonitor* monitor : monitors()) {
        glm::ivec2 origin;
        glfwGetMonitorPos(monitor, &origin.x, &origin.y);
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        if (!mode || !place.position) continue;
        const glm::ivec2 low = glm::max(*place.position, origin);
        const glm::ivec2 high = glm::min(*place.position + size, origin + glm::ivec2(mode->width, mode->height));
        const int w = high.x - low.x, h = high.y - low.y;
        if (w <= 0 || h <= 0 || w * h <= best_area) continue;
        best_area = w * h;
        best = monitor;
    }
    return best;
}

// No larger than what its monitor leaves to windows.
glm::ivec2 fitting_size(const WindowPlace& place) {
    const glm::ivec2 size = place.size.value_or(kFirstSize);
    GLFWmonitor* monitor = monitor_of(place);
    if (!monitor) return size;
    glm::ivec2 room(0);
    glm::vec2 scale(1.0f);
    glfwGetMonitorWorkarea(monitor, nullptr, nullptr, &room.x, &room.y);
    if ((!place.size && !on_a_mac()) || on_wayland()) glfwGetMonitorContentScale(monitor, &scale.x, &scale.y);
    if (room.x <= 0 || room.y <= 0) return size;
    const glm::ivec2 bars(0, on_wayland() ? 80 : 0);  // a desktop's and the window's own are not told of there
    return glm::min(size, glm::ivec2(glm::vec2(room) / glm::max(scale, glm::vec2(1.0f))) - bars);
}

}  // namespace

Window::Window(const char* title, const WindowPlace& place) {
    try {
        start_glfw(GlfwFor::Window);
    } catch (const ContextError& e) {
        throw ContextError("no window: " + std::string(e.what()) +
                           "; without a display use: normalscope capture -o OUT.png");
    }
    ask_for_opengl();
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the renderer has its own framebuffer
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    // A size that is remembered is the enlarged one, and would grow each time.
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, place.size ? GLFW_FALSE : GLFW_TRUE);
    glfwWindowHint(GLFW_MAXIMIZED, place.maximised ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, kDesktopName);
#ifdef GLFW_WAYLAND_APP_ID  // from GLFW 3.4 on
    glfwWindowHintString(GLFW_WAYLAND_APP_ID, kDesktopName);
#endif
    const glm::ivec2 size = fitting_size(place);
    const ShadersByWidth kept;
    window_ = glfwCreateWindow(size.x, size.y, title, nullptr, nullptr);
    if (!window_) {
        const std::string reason = glfw_error();
        glfwTerminate();
        throw ContextError(without_opengl("no window: " + reason));
    }
    if (place.position && !on_wayland()) glfwSetWindowPos(window_, place.position->x, place.position->y);
    glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    latest_ = settled_ = this->place();
    glfwShowWindow(window_);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::make_current() {
    glfwMakeContextCurrent(window_);
    if (!gladLoadGL(glfwGetProcAddress))
        throw ContextError(without_opengl("the window's OpenGL 3.3 context cannot be used"));
    watch_for_gl_errors();
    glfwSwapInterval(1);
}

glm::ivec2 Window::framebuffer_size() const {
    glm::ivec2 size;
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::dvec2 Window::pixels_per_pointer_unit() const {
    glm::ivec2 size;
    glfwGetWindowSize(window_, &size.x, &size.y);
    return glm::dvec2(framebuffer_size()) / glm::dvec2(std::max(size.x, 1), std::max(size.y, 1));
}

float Window::content_scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(std::max(x, y), 0.5f, 4.0f);
}

bool Window::maximised() const { return glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE; }

// A window manager resizes a window before or after it says that it is maximised, so that a place counts once it has been
// kept for a while.
void Window::watch_place() {
    constexpr double kAWhile = 0.5;  // seconds
    if (windowed_) return;
    const bool settled = glfwGetTime() - latest_since_ > kAWhile;
    if (!maximised()) {
        to_go_back_to_.reset();
        const WindowPlace now = place();
        if (now == latest_) return;
        if (settled) settled_ = latest_;
        latest_ = now;
        latest_since_ = glfwGetTime();
    } else if (!to_go_back_to_) {
        to_go_back_to_ = settled ? latest_ : settled_;
        to_go_back_to_->maximised = true;
    }
}

WindowPlace Window::place() const {
    if (windowed_) return *windowed_;
    if (to_go_back_to_) return *to_go_back_to_;
    glm::ivec2 size, position;
    glfwGetWindowSize(window_, &size.x, &size.y);
    if (on_wayland()) return {size, std::nullopt};
    glfwGetWindowPos(window_, &position.x, &position.y);
    return {size, position};
}

void Window::toggle_full_screen() {
    if (windowed_) {
        const WindowPlace back = *windowed_;
        windowed_.reset();
        const glm::ivec2 position = back.position.value_or(glm::ivec2(0));
        glfwSetWindowMonitor(window_, nullptr, position.x, position.y, back.size->x, back.size->y, GLFW_DONT_CARE);
        if (back.maximised) glfwMaximizeWindow(window_);
        return;
    }
    const WindowPlace now = place();
    GLFWmonitor* monitor = monitor_named(chosen_monitor_);
    if (!monitor) monitor = monitor_of(now);
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    windowed_ = now;
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::to_next_monitor() {
    const std::span<GLFWmonitor*> all = monitors();
    if (!windowed_ || all.size() < 2) return;
    const auto now = std::ranges::find(all, glfwGetWindowMonitor(window_));
    const auto next = now == all.end() || now + 1 == all.end() ? all.begin() : now + 1;
    const GLFWvidmode* mode = glfwGetVideoMode(*next);
    if (!mode) return;
    chosen_monitor_ = name_of(*next);
    glfwSetWindowMonitor(window_, *next, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace normalscope

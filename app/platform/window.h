#pragma once

#include "platform/context.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <utility>

struct GLFWwindow;

namespace normalscope {

/// A window's place on the desktop, to be found again next time.
struct WindowPlace {
    std::optional<glm::ivec2> size;  ///< empty: the program's own, which a monitor's scale enlarges
    std::optional<glm::ivec2> position;
    bool maximised = false;  ///< size and position are those to go back to
    friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

/// A GLFW window with its context. Throws ContextError where there is no display or no OpenGL 3.3.
class Window final : public Context {
public:
    Window(const char* title, const WindowPlace& place);
    ~Window() override;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void make_current() override;
    std::string_view name() const override { return "window"; }

    GLFWwindow* handle() const { return window_; }
    glm::ivec2 framebuffer_size() const;
    /// Framebuffer pixels per unit of the pointer's coordinates.
    glm::dvec2 pixels_per_pointer_unit() const;
    /// Physical pixels per logical one, as the desktop has it.
    float content_scale() const;
    /// Where it stands when not full screen.
    WindowPlace place() const;
    /// Whenever something has happened to it: once it is maximised nobody knows where it stood before.
    void watch_place();
    /// Full screen, on the monitor that was chosen last or else on the one that it is on, and back.
    void toggle_full_screen();
    /// While full screen: to the next monitor, whose name is remembered.
    void to_next_monitor();
    const std::string& chosen_monitor() const { return chosen_monitor_; }
    void choose_monitor(std::string name) { chosen_monitor_ = std::move(name); }
    bool full_screen() const { return windowed_.has_value(); }

private:
    GLFWwindow* window_ = nullptr;
    bool maximised() const;

    std::optional<WindowPlace> windowed_;       // set while full screen
    WindowPlace latest_, settled_;              // while not maximised; the latter had been kept for a while
    double latest_since_ = 0.0;                 // by GLFW's clock
    std::optional<WindowPlace> to_go_back_to_;  // set while maximised
    std::string chosen_monitor_;
};

}  // namespace normalscope

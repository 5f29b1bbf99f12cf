#pragma once

#include "core/frame.h"
#include "ui/interface.h"

#include <functional>

struct GLFWwindow;

namespace normalscope {

/// Dear ImGui's context and its GL backend around an Interface. Needs a current GL context, and must die before it.
class Gui {
public:
    /// `window` gets the keyboard and the mouse; none off-screen.
    explicit Gui(GLFWwindow* window = nullptr);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// One round of the interface: `content` runs between NewFrame and Render. Off-screen, time advances by a fixed
    /// step, so that the same calls give the same picture.
    void layout(glm::ivec2 framebuffer, Theme theme, float scale, const std::function<void()>& content);
    /// Draws the last round into the bound framebuffer.
    void draw() const;

    bool wants_mouse() const;
    bool wants_keyboard() const;
    /// While a slider or a handle is held, or the stack is played, a change is not finished.
    bool editing() const;
    /// Of input that comes at once, each round takes only what cannot be confused: there is more to be laid out.
    bool has_more_input() const;

    Interface interface;

private:
    bool has_window_;
};

}  // namespace normalscope

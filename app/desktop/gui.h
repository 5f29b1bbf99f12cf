#pragma once

#include "ui/interface.h"

#include <functional>

struct GLFWwindow;

namespace normalscope {

/// Dear ImGui's context around the Interface of a window, drawn by GL.
class Gui {
public:
    /// A context is current and outlives this. `window` gets the keyboard and the mouse; null: there is none, and time
    /// advances by a fixed step.
    explicit Gui(GLFWwindow* window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// One round of the interface: `content` runs between NewFrame and Render.
    void layout(glm::ivec2 framebuffer, Theme theme, float scale, const std::function<void()>& content);
    /// Draws the last round into the bound framebuffer.
    void draw() const;

    bool wants_mouse() const;
    bool wants_keyboard() const;
    /// What has been typed into a field is taken as it is.
    void finish_typing();
    /// While a slider or a handle is held, or the stack is played, a change is not finished.
    bool editing() const;
    /// The scene is changing from frame to frame: a slider is held, or the stack is being played.
    bool moving() const;
    /// Of input that comes at once, each round takes only what cannot be confused: there is more to be laid out.
    bool has_more_input() const;

    Interface interface;

private:
    bool has_window_;
};

}  // namespace normalscope

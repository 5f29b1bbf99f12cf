#pragma once

#include "core/frame.h"
#include "core/image.h"
#include "ui/interface.h"

#include <functional>

struct GLFWwindow;

namespace normalscope {

/// Dear ImGui's context around an Interface.
class Gui {
public:
    /// What draws it: GL, which needs a context that is current and outlives this, or the processor, into an Image.
    enum class Brush { Gl, Processor };
    /// `window` gets the keyboard and the mouse; none off-screen.
    explicit Gui(Brush brush, GLFWwindow* window = nullptr);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// One round of the interface: `content` runs between NewFrame and Render. Off-screen, time advances by a fixed
    /// step, so that the same calls give the same picture.
    void layout(glm::ivec2 framebuffer, Theme theme, float scale, const std::function<void()>& content);
    /// Draws the last round into the bound framebuffer,
    void draw() const;
    /// or into a picture.
    void paint(Image& image) const;

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
    Brush brush_;
    bool has_window_;
};

}  // namespace normalscope

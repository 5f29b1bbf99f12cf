#pragma once

#include "ui/interface.h"
#include "viewer/host.h"

#include <imgui.h>

#include <functional>

namespace normalscope {

/// Dear ImGui's context around the Interface of a viewer, which gives it the keyboard, the mouse and the time.
class Gui {
public:
    explicit Gui(Host& host);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// One round of the interface: `content` runs between NewFrame and Render.
    void layout(Theme theme, float scale, const std::function<void()>& content);

    void key(ImGuiKey key, bool down, ImGuiKeyChord modifiers);
    void button(int button, bool down, ImGuiKeyChord modifiers);
    /// No place: the pointer has left.
    void point(std::optional<glm::dvec2> at);

    /// Takes hold of whatever scrolls under the pointer, as a finger on a touch screen does. False: nothing does, or it is
    /// the scroll bar itself.
    bool grab_to_scroll();
    /// What it has hold of moves by so many pixels, down where positive.
    void scroll_grabbed(float pixels);
    /// What is held follows the pointer: a number, a text's cursor, a row that is being moved. A button does not.
    bool holds_what_follows() const;

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
    void modifiers(ImGuiKeyChord held);

    Host& host_;
    std::string clipboard_;  // what Dear ImGui was given last
    double time_ = 0.0;      // of the last round

    struct Grabbed {
        ImGuiID window = 0;
        float scrolled = 0.0f;  ///< by now, though Dear ImGui does it only in its next round
    } grabbed_;
};

}  // namespace normalscope

#include "viewer/viewer.h"

namespace normalscope {

void Viewer::pointer_to(glm::dvec2 pixel) {
    wake();
    gui_.point(pixel);
    Exercises& exercise = lecture().exercises;
    if (frame_) exercise.drag(*frame_, document_.scene, scale(), pixel);
    if (!frame_ || exercise.dragging()) return;
    pointer_at_ = pixel;
    pointer_.move(document_.scene, *frame_, pixel, scale(),
                  ImGui::GetIO().KeyAlt ? Pointer::Hand::Free : Pointer::Hand::Caught);
    const bool free = !pointer_.busy() && !gui_.wants_mouse() && gui_.interface.derivation_shown();
    gui_.interface.highlight(free ? highlight_at(*frame_, pixel, 7.0 * scale()) : std::nullopt);
}

void Viewer::pointer_left() {
    wake();
    gui_.point(std::nullopt);
    pointer_.leave();
    gui_.interface.highlight(std::nullopt);
}

void Viewer::press(int button, ImGuiKeyChord modifiers) {
    wake();
    end_greeting();
    catch_up();
    (void)end_path();
    gui_.button(button, true, modifiers);
    if (!frame_ || gui_.wants_mouse() || lecture().exercises.grab(*frame_, document_.scene, scale(), pointer_at_))
        return;
    commit();
    pointer_.press(document_.scene, *frame_,
                   {.left = button == ImGuiMouseButton_Left, .shift = (modifiers & ImGuiMod_Shift) != 0}, scale());
}

void Viewer::release(int button, ImGuiKeyChord modifiers) {
    wake();
    gui_.button(button, false, modifiers);
    if (frame_ && !lecture().exercises.release()) pointer_.release(document_.scene, *frame_, scale());
}

void Viewer::scroll(glm::dvec2 steps) {
    wake();
    ImGui::GetIO().AddMouseWheelEvent(static_cast<float>(steps.x), static_cast<float>(steps.y));
    if (!gui_.wants_mouse()) pointer_.scroll(document_.scene, steps.y);
}

bool Viewer::grab_to_scroll() {
    wake();
    catch_up();
    return gui_.grab_to_scroll();
}

void Viewer::scroll_grabbed(double pixels) {
    wake();
    gui_.scroll_grabbed(static_cast<float>(pixels));
}

void Viewer::focus(bool focused) {
    wake();
    ImGui::GetIO().AddFocusEvent(focused);
}

}  // namespace normalscope

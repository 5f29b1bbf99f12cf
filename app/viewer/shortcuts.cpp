#include "core/frame/drawn_arrows.h"
#include "core/picture/picking.h"
#include "viewer/lecture_keys.h"
#include "viewer/scene_keys.h"
#include "viewer/viewer.h"

#include <algorithm>
#include <array>

namespace normalscope {

namespace {

// With Ctrl; what a field knows itself, such as Ctrl+Z, is meant for its text.
bool leaves_a_field(ImGuiKey key) {
    constexpr std::array kKeys{ImGuiKey_F, ImGuiKey_L, ImGuiKey_O, ImGuiKey_P, ImGuiKey_Q, ImGuiKey_S};
    return std::ranges::find(kKeys, key) != kKeys.end();
}

}  // namespace

void Viewer::press(const KeyPress& key) {
    wake();
    end_greeting();
    if (!key.repeated) catch_up();
    gui_.interface.key_was_pressed();
    pointer_.end_scrolling();
    if (key.key == ImGuiKey_Escape && !key.repeated && give_up_surface()) return;
    if (!key.repeated && end_path()) return;
    if (to_lecture(key)) return;
    if (!key.repeated) gui_.key(key.key, true, key.modifiers);
    // A key that is held must not switch back and forth.
    if (!key.repeated || key.control() || key.alt()) shortcut(key);
}

void Viewer::release(const KeyPress& key) {
    wake();
    // Dear ImGui takes what was pressed with it as pressed without it, if both come before one picture.
    if (key.is_modifier()) catch_up();
    gui_.key(key.key, false, key.modifiers);
}

void Viewer::type(char32_t letter) {
    wake();
    ImGui::GetIO().AddInputCharacter(letter);
}

bool Viewer::to_lecture(const KeyPress& key) {
    // Whatever is pressed, people see the picture again.
    if (!key.repeated && key.key != ImGuiKey_F5 && key.key != ImGuiKey_F11 && lecture().end_blank()) return true;
    const auto meant = lecture().asking() ? lecture_key_while_asking(key.key) : lecture_key(key.key);
    if (!meant || key.control() || key.alt() || pointer_.busy() || !gui_.interface.keys_are_free()) return false;
    // A key that is held turns an exercise's arrow on and on; it does not run through a lesson and into the next one.
    if (key.repeated && !exercising()) return true;
    commit();
    return lecture().press(*meant, document_.scene, frame());
}

void Viewer::shortcut(const KeyPress& key) {
    switch (key.key) {
        case ImGuiKey_F1: return gui_.interface.toggle_help();
        case ImGuiKey_F11: return host_.toggle_full_screen();
        case ImGuiKey_F5: return present(!presenting());
        default: break;
    }
    if (pointer_.busy() || gui_.interface.dialog_shown()) return;
    if (gui_.wants_keyboard()) {
        if (!key.control() || !leaves_a_field(key.key)) return;
        gui_.finish_typing();
    }
    commit();
    if (key.control()) return shortcut_with_control(key);
    if (key.alt()) return move_probe(key.key);
    if (press_view_key(document_.scene, key.key)) return;
    if (!exercising()) {  // what is asked must stay what it is
        if (const auto rule = rule_of(key.key)) return choose(*rule);
        if (press_object_key(document_.scene, key.key)) return;
    }
    switch (key.key) {
        case ImGuiKey_P: pin_probe(); break;
        case ImGuiKey_M:
            if (presenting()) host_.to_next_monitor();
            break;
        case ImGuiKey_Tab:
            if (gui_.interface.tab_is_free()) gui_.interface.toggle_panel();
            break;
        case ImGuiKey_H: gui_.interface.toggle_panel(); break;
        case ImGuiKey_F: frame_surface(); break;
        default: break;
    }
}

void Viewer::move_probe(ImGuiKey key) {
    constexpr double kStep = 6.0;  // logical pixels
    glm::dvec2 by(0.0);
    switch (key) {
        case ImGuiKey_LeftArrow: by.x = -kStep; break;
        case ImGuiKey_RightArrow: by.x = kStep; break;
        case ImGuiKey_UpArrow: by.y = -kStep; break;
        case ImGuiKey_DownArrow: by.y = kStep; break;
        default: return;
    }
    if (exercising() || !frame_) return;
    if (const auto point = probe_moved(*frame_, world_from_object(document_.scene), static_cast<double>(scale()) * by))
        document_.scene.probe = point;
}

void Viewer::pin_probe() {
    if (exercising() || !frame_ || !frame_->probe) return;
    std::vector<Point<Object>>& pinned = document_.scene.pinned;
    const Point<Object> point = frame_->probe->object.point;
    if (std::ranges::find(pinned, point.xyz, &Point<Object>::xyz) != pinned.end())
        gui_.interface.show_note("This point is already pinned");
    else if (pinned.size() >= Scene::kMostPinned)
        gui_.interface.show_note("At most four points can be pinned: remove one first, in its row in the panel");
    else
        pinned.push_back(point);
}

void Viewer::shortcut_with_control(const KeyPress& key) {
    switch (key.key) {
        case ImGuiKey_Z: return undo(key.shift() ? Direction::Redo : Direction::Undo);
        case ImGuiKey_Y: return undo(Direction::Redo);
        case ImGuiKey_O: return gui_.interface.ask_open();
        case ImGuiKey_S: return key.shift() ? ask_save() : save();
        case ImGuiKey_F:
            if (!exercising()) gui_.interface.edit_formula(document_.scene);
            return;
        case ImGuiKey_P: return gui_.interface.ask_save_picture();
        case ImGuiKey_C: return copy_command();
        case ImGuiKey_L: return key.shift() ? copy_equations() : copy_link();
        case ImGuiKey_V: return paste();
        case ImGuiKey_Equal:
        case ImGuiKey_KeypadAdd: return scale_.change(presenting(), +1);
        case ImGuiKey_Minus:
        case ImGuiKey_KeypadSubtract: return scale_.change(presenting(), -1);
        case ImGuiKey_0:
        case ImGuiKey_Keypad0: return scale_.change(presenting(), 0);
        case ImGuiKey_Q: return close();
        default: return;
    }
}

void Viewer::choose(Rule rule) {
    Scene& scene = document_.scene;
    if (!can_choose(scene, rule)) return;
    swing_ = motion_ ? Swing::to(rule, scene, host_.now()) : std::nullopt;
    scene.rule = rule;
    if (rule != Rule::Cofactor) scene.power = 1.0;  // whoever asks for a rule wants that rule
}

void Viewer::present(bool presenting) {
    lecture().present(presenting);
    if (host_.full_screen() != presenting) host_.toggle_full_screen();
}

void Viewer::commit_if_finished() {
    if (!pointer_.busy() && !gui_.editing()) commit();
}

void Viewer::undo(Direction direction) {
    if (exercising()) return;
    gui_.interface.finish_playing(document_.scene);  // where it happens to be is nothing that anybody did
    commit();
    const bool redo = direction == Direction::Redo;
    int steps = 0;
    while (redo ? document_.can_redo() : document_.can_undo()) {
        redo ? document_.redo() : document_.undo();
        if (can_be_drawn(document_.scene)) return follow_draft();
        ++steps;
    }
    for (; steps > 0; --steps) redo ? document_.undo() : document_.redo();
}

}  // namespace normalscope

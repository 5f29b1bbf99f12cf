#pragma once

#include "viewer/hosted.h"

namespace normalscope {

/// Writes lessons in the window.
class WritingLessonsTest : public ViewerTest {
protected:
    const Lesson& lesson() const { return lecture().player.lesson(); }
    std::size_t step() const { return lecture().player.number(); }
    void learn(const char* row) {
        click(Item("##panel/##always") / "Learn");
        click(Item("##Popup") / row);
    }
    void write_into(const Item& field, std::string_view words) {
        click(field);
        keys({ImGuiMod_Ctrl | ImGuiKey_A, ImGuiKey_Delete});
        type(words);
        click(ground());
    }
    void press_in_editor(const char* button) { click(Item("##writing") / button); }
    static bool editor_is_shown() {
        const ImGuiWindow* window = ImGui::FindWindowByName("##writing");
        return window && window->Active;
    }
    bool picture_has_room_beside() {
        return viewer().frame()->rect.origin.x + viewer().frame()->rect.size.x < host_.size.x;
    }
    void undo() { key(ImGuiMod_Ctrl | ImGuiKey_Z); }
    std::string own() const { return path("mine.json"); }
};

}  // namespace normalscope

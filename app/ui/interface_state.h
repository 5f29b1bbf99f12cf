#pragma once

#include "core/lessons/tabs.h"
#include "ui/arrangement.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/messages.h"
#include "ui/kit/question.h"
#include "ui/kit/side_panel.h"
#include "ui/kit/unfolded.h"
#include "ui/lecture/lecture.h"
#include "ui/lecture/lesson_editor.h"
#include "ui/panel/drawer.h"
#include "ui/panel/panel_memory.h"
#include "ui/probe_trail.h"
#include "ui/tabs/derivation_panel.h"
#include "ui/tabs/error_tab.h"
#include "ui/tabs/maps_tab.h"
#include "ui/tabs/stack_tab.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace normalscope {

inline constexpr double kPointerShown = 4.0;  ///< seconds, after it has come to rest
inline constexpr std::size_t kDerivation = 0;
static_assert(kTabs[kDerivation].name == "derivation");

/// All that the interface remembers, and what is done with more than one part of it.
struct InterfaceState {
    Look look;
    ExtraLetters letters;
    std::weak_ptr<const Lesson> lettered;  ///< whose letters have been asked for
    PanelMemory panel;
    DerivationPanel derivation;
    FileDialog dialog;
    QuestionBox question;
    Messages messages;
    SideMemory side;
    StackTab stack;
    ProbeTrail trail;
    MapsTab maps;
    ErrorTab error;
    LessonEditor editor;
    bool editor_shown = false, writing = false;
    bool edits() const { return editor_shown && writing && lecture.player.running() && !lecture.presenting; }
    /// A remote control cannot scroll; a picture by itself is made as high as it must be.
    bool shows_all_lines() const { return lecture.presenting && !look.still; }
    mutable Lecture lecture;  // which remembers what it has measured
    bool captions = false;    ///< their fonts are in the atlas
    bool panel_shown = true, help = false;
    bool drawer_open = false;  ///< the panel's, where it is one: the picture comes first
    Unfolded unfolded;
    double wake = std::numeric_limits<double>::infinity();
    double pointer_rested = 0.0;  ///< since when, by ImGui::GetTime
    double popups_changed = -1e9, presented_until = -1e9;
    bool popup = false;
    bool menu_open = false;    ///< or any list, at the end of the frame before
    bool item_active = false;  ///< such as a field that is typed in, at the end of the frame before

    void watch_the_clock();
    /// A dialog is open, or will be in the next frame.
    bool asks() const { return dialog.is_open() || question.is_open(); }
    /// Presenting first; a lesson only when asked again, and later: a key that bounces ends no lecture.
    void leave_one_thing(Scene& scene, const Status& status, Requests& requests);
    /// Asks first where something would be lost.
    void leave_lecture(Scene& scene, const Status& status);
    void ask_to_leave_lesson(const Status& status);
    std::vector<SideTab> tabs();
    /// Shown or not, in a window of this size.
    bool& panel_wanted(glm::ivec2 framebuffer) { return is_drawer(look, framebuffer) ? drawer_open : panel_shown; }
    /// Who gets which part of the framebuffer.
    Arrangement arrangement(glm::ivec2 framebuffer) const;
    /// The sentence above the picture, and what is pressed there.
    void draw_strip(Scene& scene, const Frame& frame, const Status& status, Requests& requests);
    /// Where a lesson is written: its words and steps.
    void draw_editor(const Scene& scene, const Frame& frame, const Status& status, Requests& requests);
    /// The derivation's line on which the rule that is chosen stands or falls.
    void ask_why(const Scene& scene);
    void want_letters_of_lesson();
};

}  // namespace normalscope

#pragma once

#include "core/base/font_file.h"
#include "core/base/letter_picture.h"
#include "core/frame/frame.h"
#include "core/frame/step_marks.h"
#include "core/lessons/lesson.h"
#include "core/math/highlight.h"
#include "core/scene/scene.h"
#include "ui/kit/requests.h"
#include "ui/kit/unfolded.h"
#include "ui/lecture/lecture.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

struct InterfaceState;

/// Dear ImGui on a scene: the panel, the words on the picture, help, file dialogs and messages. Owns no ImGui context:
/// one must be current, whose unit is the framebuffer's pixel. Knows neither GL nor the window.
class Interface {
public:
    Interface();
    ~Interface();
    Interface(Interface&&) noexcept;
    Interface& operator=(Interface&&) noexcept;

    /// Before ImGui::NewFrame: fonts and style for a theme and a scale (physical pixels per logical one). The font atlas
    /// is made anew where the scale changed or letters are missing; true says so, and that the backend must upload it again.
    bool prepare(Theme theme, float scale);

    /// Fonts for letters that the program's own lack, or who draws such letters.
    void find_fonts_by(FindFonts find);
    void draw_letters_by(DrawLetter draw);

    /// Where the picture goes in a framebuffer of this size: what the panels, and the strip of words below, leave.
    PixelRect picture(glm::ivec2 framebuffer) const;

    /// Between ImGui::NewFrame and ImGui::Render: draws everything over `frame` and edits the scene.
    Requests draw(Scene& scene, const Frame& frame, const Status& status);
    /// Only the words on the picture (labels, legend), as in a capture without the panel.
    void draw_words(const Frame& frame) const;
    /// What these cover, in pixels of the framebuffer.
    std::vector<PixelRect> word_boxes(const Frame& frame) const;

    /// One line that the user must see, such as why a file was refused; shown until dismissed or replaced.
    void show_error(std::string_view line);
    /// Takes such a line away: what it said is so no more.
    void take_back(std::string_view line);
    /// One line that may go by itself, such as "Still reading a file".
    void show_note(std::string_view line);
    /// The same of what has been done, such as "Saved …": an error of an earlier try goes.
    void show_done(std::string_view line);
    /// Whichever there is.
    void dismiss_error();
    /// Takes such a note away.
    void take_back_note(std::string_view line);
    /// The line that is shown now; empty if none.
    std::string_view message() const;

    /// The derivation, at the right of the picture; key D.
    void show_derivation(bool shown);
    bool derivation_shown() const;
    /// What the picture shows beyond the scene: a lesson's step, and the line at which the derivation stands.
    StepMarks marks() const;
    /// What the pointer is on in the derivation, as of the last draw: the picture lights it up.
    std::optional<Highlight> highlighted() const;
    /// What the pointer is on in the picture: the derivation lights it up, until told otherwise.
    void highlight(const std::optional<Highlight>& in_picture);

    /// Seconds until it wants to be drawn again though nothing happens, such as for a tooltip; infinite if never. Beyond
    /// that, Dear ImGui needs two more frames after each event to settle.
    double redraw_after() const;

    /// Opens a tab beside the picture, by its name (core/lessons/tabs.h); an empty one closes it. "derivation#5" is gone
    /// through step by step, from the fifth line on. False for an unknown name.
    bool show_tab(std::string_view id);
    /// The same for a picture that shows nothing else beside it, and nothing to press.
    bool record_tab(std::string_view id);
    /// While the stack or a lesson is being played the scene changes by itself: what it goes through is nothing to be
    /// undone.
    bool playing() const;
    /// What the panel shows beyond a first look.
    Unfolded& unfolded();
    const Unfolded& unfolded() const;
    /// The files that were opened or saved, the newest first: the dialog offers them.
    std::vector<std::string>& recent_files();
    const std::vector<std::string>& recent_files() const;
    /// The stack from nothing to whole.
    void play(Scene& scene);
    void finish_playing(Scene& scene);
    bool typing_formula() const;
    /// The pointer's tip goes, until it moves again.
    void key_was_pressed();

    /// The formula's field gets the keyboard; another surface gives way to a formula.
    void edit_formula(Scene& scene);
    /// Goes through a lesson, from `step` or from where it was left.
    void open_lesson(std::shared_ptr<const Lesson> lesson, const Scene& scene, std::optional<std::size_t> step = {});
    /// The same for a picture of a step: nothing moves, and there is nothing to press.
    /// `answer`: the choice that is made of its question, or none yet.
    void record_lesson(const std::shared_ptr<const Lesson>& lesson, const Scene& scene, std::size_t step,
                       std::optional<std::size_t> answer);
    /// The lesson, the exercises, and how they are shown in a room.
    Lecture& lecture();
    const Lecture& lecture() const;
    /// Keys mean something else while somebody writes, or moves about the panel by keyboard.
    bool keys_are_free() const;
    /// Tab goes from field to field where a lesson is written.
    bool tab_is_free() const;

    void toggle_help();
    void toggle_panel();
    bool panel_shown() const;
    void ask_open();
    /// Something that is to be opened is asked for, by a dialog that is about to appear; or no more.
    bool asks_for_file() const;
    void ask_no_more();
    void ask_save_scene();
    void ask_save_lesson(const std::filesystem::path& folder);  ///< empty: where one was last
    void ask_save_picture();
    /// Asks before anything else goes on; the answer is among the requests.
    void ask(Asked what, std::string title, std::string text, std::vector<std::string> choices);
    /// A dialog is open, or will be in the next frame: keys are for it alone.
    bool dialog_shown() const;

private:
    std::unique_ptr<InterfaceState> state_;
};

}  // namespace normalscope

#pragma once

#include "core/base/beside.h"
#include "core/picture/picking.h"
#include "core/surface/level_sets.h"
#include "viewer/document.h"
#include "viewer/errors_cache.h"
#include "viewer/file_watch.h"
#include "viewer/gui.h"
#include "viewer/host.h"
#include "viewer/key_press.h"
#include "viewer/opening.h"
#include "viewer/pace.h"
#include "viewer/pointer.h"
#include "viewer/remembered.h"
#include "viewer/surface_in_time.h"
#include "viewer/swing.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace normalscope {

/// The program that a window shows: events edit the scene, the scene becomes a frame, and the host draws it. Whoever
/// hosts it passes on what happens, and calls step() after that and whenever it is due. Pixels are the framebuffer's.
class Viewer {
public:
    /// What is to be seen first is prepared. The host outlives this.
    Viewer(Host& host, Opened first, Remembered remembered = {});
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    void pointer_to(glm::dvec2 pixel);
    void pointer_left();
    /// Of Dear ImGui's buttons: 0 is the left one.
    void press(int button, ImGuiKeyChord modifiers);
    void release(int button, ImGuiKeyChord modifiers);
    /// Positive y: away from the user.
    void scroll(glm::dvec2 steps);
    /// By a finger that moves up or down: what is under the pointer scrolls with it. False: nothing there does.
    bool grab_to_scroll();
    /// By so many pixels, down where positive.
    void scroll_grabbed(double pixels);
    /// What is held follows the pointer, as a number does; a button does not, and is pressed only by a tap.
    bool holds_what_follows() const { return pointer_.busy() || gui_.holds_what_follows(); }
    void press(const KeyPress& key);
    void release(const KeyPress& key);
    void type(char32_t letter);
    void focus(bool focused);
    /// The window was resized or uncovered, or is on another monitor.
    void expose() { wake(); }
    /// A file, a link, or whatever else has a name: in the background, where that takes time.
    void open(const std::string& name);
    /// The user wants to leave: asks first where work would be lost.
    void close();

    /// Has all drawn that is to be drawn now.
    void step();
    /// Seconds until step() has something to do though nothing happens; infinite if never.
    double due() const;
    /// Something is being read in the background.
    bool opening() const { return static_cast<bool>(opening_); }
    /// A formula's surface is being made in the background, and the one before is shown.
    bool making_surface() const { return surfaces_.making(); }

    /// Where the user keeps lessons, to be listed behind the built-in ones.
    void take_lessons_from(std::vector<std::filesystem::path> folders);

    /// For a picture by itself, as in a page of others.
    void show_panel(bool shown);
    /// Whether anything may move by itself.
    void set_motion(bool moves);
    /// As F5 does, where there is no full screen.
    void present_in_place();
    /// As it is seen, without the panel; a name that ends in .svg gets the vector parts. Throws InputError.
    void save_picture(const std::filesystem::path& file);
    /// One line that the user must see.
    void complain(std::string_view line);
    /// What is seen in words, for whoever does not see it: the scene's sentence, its rule, the angle at the probe.
    std::string description() const;
    /// What is seen, as a page's address has it after "#": its name where it has one, or else a link.
    std::string address() const;
    Remembered remembered() const;
    const Scene& scene() const { return document_.scene; }
    const Interface& interface() const { return gui_.interface; }
    /// As drawn last; null before the first step.
    const Frame* frame() const { return frame_ ? &*frame_ : nullptr; }

private:
    Lecture& lecture() { return gui_.interface.lecture(); }
    const Lecture& lecture() const { return gui_.interface.lecture(); }
    bool presenting() const { return lecture().presenting; }
    bool exercising() const { return lecture().exercises.running(); }
    /// What is seen is a lesson's step, or comes from one.
    bool in_lesson() const {
        const LessonPlayer& player = lecture().player;
        return player.running() && (document_.draft.lesson ? document_.draft.lesson == player.shared_lesson()
                                                           : document_.file() == player.lesson().name);
    }
    void wake();
    void end_greeting();
    /// What a step shows by itself is over with any press; of a key's, that is all. Whether it was.
    bool end_path();
    /// When the interface wants to be drawn again though nothing happens, by the host's clock.
    double wake_at() const { return laid_out_at_ + gui_.interface.redraw_after(); }

    // What is seen: viewer.cpp
    enum class Marks { WithHandles, AsSaved };
    bool has_room() const;
    /// A mesh's file may be gone by now: then this is said.
    bool can_be_drawn(const Scene& scene);
    void draw();
    /// Frame and interface as of now.
    Requests compose();
    /// The interface over the last frame; it may change the scene.
    Requests lay_out();
    /// Until the interface knows of all input so far.
    void catch_up();
    Frame frame_now(Marks marks);
    /// Says so where a formula's surface takes long, and that Esc gives it up.
    void tell_of_waiting();
    /// Says how to find the object where a change of the scene, but not of the camera, has taken it out of the picture.
    void tell_of_lost_object();
    /// Back to the scene before; a redo tries again. Whether there was something to give up.
    bool give_up_surface();
    void obey(const Requests& requests);
    /// The surface with its arrows; empty where there is none.
    std::optional<WorldBall> surface_ball() const;
    /// The surface and its axes, ghost and arrows fill the picture.
    void frame_surface();
    /// The scene as this room should see it: a projector needs contrast.
    Scene shown_scene() const;
    /// How the rules' arrows stand, as long as they swing to their place.
    std::optional<Swing::Powers> swinging() const;
    /// What the picture shows beyond the scene; `marks` as saved: with all that a line carries at its end.
    StepMarks step_marks(Marks marks) const;
    /// Physical pixels per logical one, as desktop, user and room want it.
    float scale() const;

    // What the keys do: shortcuts.cpp
    /// Whether the key was for a lesson or a lecturer.
    bool to_lecture(const KeyPress& key);
    void shortcut(const KeyPress& key);
    void shortcut_with_control(const KeyPress& key);
    void move_probe(ImGuiKey key);
    void pin_probe();
    /// By key or button: its arrows swing to where it wants them.
    void choose(Rule rule);
    void present(bool presenting);
    /// What the user has finished doing becomes one step to undo.
    void commit_if_finished();
    void commit() {
        if (!exercising() && !gui_.interface.playing()) document_.commit();
    }
    enum class Direction { Undo, Redo };
    /// To the next state that can be drawn.
    void undo(Direction direction);

    // Lessons of the user's own: own_lessons.cpp
    void list_lessons();
    /// Whether the open lesson has a file.
    bool lesson_is_watched() const { return in_lesson() && !is_built_in_lesson(document_.file()); }
    void write(Writing what);
    void write(const Draft& draft);
    /// After an undo, the lesson that is written may be another, or none.
    void follow_draft();
    void save_lesson(const std::filesystem::path& file);
    /// Reads the lesson again where somebody has written to its file.
    void watch_lesson();

    // What comes in and goes out: exchange.cpp
    void finish_opening();
    void take(Opened opened);
    /// Among those that the dialog offers, if it is a file.
    void note_file(const std::filesystem::path& file);
    /// A link may hold the very scene that an earlier session did not come to save: then that goes on without a question.
    void go_on_with_what_is_shown();
    /// What an earlier session did not come to save.
    void offer();
    void obey(const Reply& reply);
    void leave_exercises();
    /// Whether to save all that is not, one after the other.
    void ask_to_save(const std::vector<Work>& works);
    /// Has the host keep these works, and what is offered still.
    void keep(const std::vector<Work>& works);
    /// To the open file, or to one that is asked for.
    void save();
    void ask_save();
    /// A new lesson goes where Learn finds it.
    void ask_save_lesson();
    void save_scene(const std::filesystem::path& file);
    void copy_command();
    void copy_link();
    void copy_frame();
    void copy_equations();
    void paste();
    void show_title();

    Host& host_;
    Gui gui_;
    DisplayScale scale_;
    Pace pace_;
    SurfaceInTime surfaces_;
    std::optional<Camera> seen_by_;  ///< the camera that had the object in the picture last
    double waiting_since_ = 0.0;     ///< for a formula's surface, by the host's clock
    LevelSetsCache level_sets_;
    FlatCutCache flat_cut_;
    ErrorsCache errors_;

    bool motion_ = true;       ///< nothing moves by itself where it is unwanted
    bool wants_room_ = false;  ///< once the surface is there
    bool greeting_ = false;    ///< the stack is played at the very first start, until anything is pressed
    std::optional<Swing> swing_;
    std::optional<DerivationAt> line_;      ///< of the derivation, as of the last round
    std::optional<double> carrying_since_;  ///< its arrows are on their way, by the host's clock

    Document document_;
    std::shared_ptr<Origin> origin_before_exercises_;
    std::string title_;
    std::vector<UnsavedWork> kept_;   ///< by the host
    std::optional<double> keep_due_;  ///< for what is being typed, by the host's clock
    bool closes_when_saved_ = false;
    std::vector<UnsavedWork> offered_;
    bool unanswered_ = false;  // whether to go back to them
    std::optional<Frame> frame_;
    Pointer pointer_;
    glm::dvec2 pointer_at_{0.0};
    Beside<Opened> opening_;

    std::vector<std::filesystem::path> lesson_folders_;
    FileWatch watch_;              ///< of the open lesson
    std::string watch_complaint_;  ///< why it could not be read again

    int frames_wanted_;
    double laid_out_at_;  ///< by the host's clock

    /// What the host's samples hold.
    struct Drawn {
        glm::ivec2 framebuffer{0};
        Scene scene;
        std::shared_ptr<const Surface> surface;
        PixelRect rect;
        std::optional<int> hot_axis;
        std::optional<Highlight> highlight;
        Quality quality = Quality::Fine;
        bool rough = false;
        double right_power = -1.0;
        StepMarks marks;
        std::optional<Vector<World>> arrow;
        friend bool operator==(const Drawn&, const Drawn&) = default;
    };
    std::optional<Drawn> drawn_;
};

}  // namespace normalscope

#include "desktop/desktop.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/explain/explanation.h"
#include "core/image/png.h"
#include "core/lessons/link.h"
#include "core/lessons/open_scene.h"
#include "core/picture/axis_handles.h"
#include "core/picture/frame.h"
#include "core/picture/make_frame.h"
#include "core/picture/picking.h"
#include "core/picture/svg.h"
#include "core/scene/history.h"
#include "core/scene/scene_json.h"
#include "desktop/gui.h"
#include "desktop/settings.h"
#include "gl/renderer.h"
#include "gl/target.h"
#include "viewer/copied_command.h"
#include "viewer/lecture_keys.h"
#include "viewer/opening.h"
#include "viewer/pace.h"
#include "viewer/pointer.h"
#include "viewer/scene_keys.h"

#define GLFW_INCLUDE_NONE  // GL's declarations come from glad
#include <GLFW/glfw3.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <optional>

namespace normalscope {

namespace {

constexpr int kSamples = 4;
// Dear ImGui settles over a few frames after an event: a hovered button lights up in the next one.
constexpr int kFramesAfterEvent = 3;

// With Ctrl; what a field knows itself, such as Ctrl+Z, is meant for its text.
bool leaves_a_field(int key) {
    constexpr std::array kKeys{GLFW_KEY_F, GLFW_KEY_L, GLFW_KEY_O, GLFW_KEY_P, GLFW_KEY_Q, GLFW_KEY_S};
    return std::ranges::find(kKeys, key) != kKeys.end();
}

// A link is as long as its scene, and says nothing to people.
std::string short_name(const std::string& file) {
    return is_link(file) ? "link" : std::filesystem::path(file).filename().string();
}

/// The window's program: events edit the scene, the scene becomes a frame, the frame a picture.
class Viewer {
public:
    Viewer(Scene scene, const std::string& file);
    ~Viewer();
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;

    void run();

private:
    void connect();
    void wait();
    bool redraw();  ///< false where there is nothing to draw on
    /// Until the interface knows of all input so far: whose the next press is depends on what lies under the pointer by
    /// now, and on whether something is being typed.
    /// What is typed into a formula is not drawn letter by letter where letters come faster than pictures.
    void catch_up() {
        while (gui_.has_more_input())
            if (gui_.interface.typing_formula() && frame_)
                obey(lay_out());
            else if (!redraw())
                return;
    }
    /// The interface over the last frame; it may change the scene.
    Requests lay_out();
    Frame frame_now(bool handles);
    /// The surface with its arrows; empty where there is none.
    std::optional<WorldBall> surface_ball() const;
    void obey(const Requests& requests);
    void begin_opening(const std::string& file);
    void finish_opening();
    void save_picture(const std::filesystem::path& file);
    void copy_command();
    void show(const Scene& scene) { scene_ = scene; }
    /// The scene as this room should see it: a projector needs contrast.
    Scene shown_scene() const;
    /// Physical pixels per logical one, as desktop, user and room want it.
    float scale() const;
    void change_scale(int steps);
    void present(bool presenting);
    /// Whether the key was for a lesson or a lecturer.
    bool to_lecture(int key, int action, int modifiers);
    void on_key(int key, int modifiers);
    void set_title();
    void copy_link();
    void copy_equations();
    void paste();
    /// What the user has finished doing becomes one step to undo.
    void commit_if_finished() {
        if (!pointer_.busy() && !gui_.editing()) commit();
    }
    void commit() {
        if (!gui_.interface.exercising()) history_.commit(scene_);
    }
    void undo(bool redo);
    template <class Handler>
    static void on_event(GLFWwindow* window, Handler&& handler) {
        auto& viewer = *static_cast<Viewer*>(glfwGetWindowUserPointer(window));
        viewer.frames_wanted_ = kFramesAfterEvent;
        handler(viewer);
    }

    Settings settings_ = load_settings();
    Window window_{"Normalscope", settings_.place};
    struct Current {  // before everything that needs GL
        explicit Current(Window& window) { window.make_current(); }
    } current_{window_};
    Renderer renderer_;
    Gui gui_{window_.handle()};
    std::optional<Target> target_, rough_target_;  // the latter while something moves that takes its time
    Pace pace_;
    std::unique_ptr<SurfaceCache> surfaces_ = std::make_unique<SurfaceCache>();
    LevelSetsCache level_sets_;

    Scene scene_;
    History history_;
    std::string file_, file_before_exercises_;
    std::optional<Frame> frame_;
    Pointer pointer_;
    glm::dvec2 pointer_at_{0.0};
    std::future<Opened> opening_;
    int frames_wanted_ = kFramesAfterEvent;

    /// What the target's samples hold.
    struct Drawn {
        Scene scene;
        std::shared_ptr<const Surface> surface;
        PixelRect rect;
        std::optional<int> hot_axis;
        std::optional<Highlight> highlight;
        Quality quality = Quality::Fine;
        bool rough = false;
        std::optional<Vector<World>> guess;
        friend bool operator==(const Drawn&, const Drawn&) = default;
    };
    std::optional<Drawn> drawn_;

    // The error statistics go over every normal: only when the matrix or the surface changed.
    std::shared_ptr<const Surface> measured_surface_;
    glm::dmat4 measured_matrix_{0.0};
    std::optional<NormalMap> measured_map_;
    std::optional<ErrorStatistics> errors_;
};

Viewer::Viewer(Scene scene, const std::string& file) : scene_(std::move(scene)), history_(scene_) {
    gui_.interface.lesson_progress() = settings_.lessons;
    window_.choose_monitor(settings_.monitor);
    connect();
    // The scene is there already; lessons and exercises are more than one.
    if (!file.empty() && is_more_than_a_scene(file)) {
        begin_opening(file);
        finish_opening();  // mostly done: then nothing else is seen first
    } else {
        file_ = file;
    }
    set_title();
}

Viewer::~Viewer() {
    settings_.place = window_.place();
    settings_.lessons = gui_.interface.lesson_progress();
    settings_.monitor = window_.chosen_monitor();
    save_settings(settings_);
}

Scene Viewer::shown_scene() const {
    Scene scene = scene_;
    if (gui_.interface.presenting()) scene.theme = theme_of(is_dark(scene.theme), true);
    return scene;
}

float Viewer::scale() const {
    return settings_.scale.of(window_.content_scale(), window_.framebuffer_size(), gui_.interface.presenting());
}

void Viewer::change_scale(int steps) { settings_.scale.change(gui_.interface.presenting(), steps); }

void Viewer::present(bool presenting) {
    gui_.interface.present(presenting);
    if (window_.full_screen() != presenting) window_.toggle_full_screen();
}

bool Viewer::to_lecture(int key, int action, int modifiers) {
    // Whatever is pressed, people see the picture again.
    if (action == GLFW_PRESS && key != GLFW_KEY_F5 && key != GLFW_KEY_F11 && gui_.interface.end_blank()) return true;
    const auto meant = lecture_key(key);
    if (!meant || action == GLFW_RELEASE || (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT)) != 0 || pointer_.busy() ||
        !gui_.interface.keys_are_free())
        return false;
    // A key that is held turns an exercise's arrow on and on; it does not run through a lesson and into the next one.
    if (action == GLFW_REPEAT && !gui_.interface.exercising()) return true;
    commit();
    return gui_.interface.press(*meant, scene_, frame_ ? &*frame_ : nullptr);
}

void Viewer::set_title() {
    const std::string title = (file_.empty() ? "" : short_name(file_) + " \u2013 ") + "Normalscope";
    glfwSetWindowTitle(window_.handle(), title.c_str());
}

void Viewer::connect() {
    GLFWwindow* w = window_.handle();
    glfwSetWindowUserPointer(w, this);
    // Dear ImGui gets each event first, the pointer's place in framebuffer pixels, in which everything is laid out.
    glfwSetCursorPosCallback(w, [](GLFWwindow* window, double x, double y) {
        on_event(window, [&](Viewer& v) {
            const glm::dvec2 at = glm::dvec2(x, y) * v.window_.pixels_per_pointer_unit();
            ImGui_ImplGlfw_CursorPosCallback(window, at.x, at.y);
            if (!v.frame_ || v.gui_.interface.drag(*v.frame_, v.scene_, v.scale(), at)) return;
            v.pointer_at_ = at;
            v.pointer_.move(v.scene_, *v.frame_, at, v.scale());
            const bool free = !v.pointer_.busy() && !v.gui_.wants_mouse() && v.gui_.interface.derivation_shown();
            v.gui_.interface.highlight(free ? highlight_at(*v.frame_, at, 7.0 * v.scale()) : std::nullopt);
        });
    });
    glfwSetMouseButtonCallback(w, [](GLFWwindow* window, int button, int action, int modifiers) {
        on_event(window, [&](Viewer& v) {
            if (action == GLFW_PRESS) v.catch_up();
            ImGui_ImplGlfw_MouseButtonCallback(window, button, action, modifiers);
            if (!v.frame_) return;
            if (action == GLFW_RELEASE && v.gui_.interface.release()) return;
            if (action == GLFW_PRESS && !v.gui_.wants_mouse() &&
                v.gui_.interface.grab(*v.frame_, v.scene_, v.scale(), v.pointer_at_))
                return;
            if (action == GLFW_RELEASE)
                v.pointer_.release(v.scene_, *v.frame_, v.scale());
            else if (!v.gui_.wants_mouse()) {
                v.commit();
                v.pointer_.press(v.scene_, *v.frame_,
                                 {.left = button == GLFW_MOUSE_BUTTON_LEFT, .shift = (modifiers & GLFW_MOD_SHIFT) != 0},
                                 v.scale());
            }
        });
    });
    glfwSetScrollCallback(w, [](GLFWwindow* window, double x, double y) {
        on_event(window, [&](Viewer& v) {
            ImGui_ImplGlfw_ScrollCallback(window, x, y);
            if (!v.gui_.wants_mouse()) v.pointer_.scroll(v.scene_, y);
        });
    });
    glfwSetKeyCallback(w, [](GLFWwindow* window, int key, int code, int action, int modifiers) {
        on_event(window, [&](Viewer& v) {
            if (action == GLFW_PRESS) v.catch_up();
            v.gui_.interface.key_was_pressed();
            if (v.to_lecture(key, action, modifiers)) return;
            ImGui_ImplGlfw_KeyCallback(window, key, code, action, modifiers);
            // A key that is held must not switch back and forth.
            if (action == GLFW_PRESS || (action == GLFW_REPEAT && (modifiers & GLFW_MOD_CONTROL) != 0))
                v.on_key(key, modifiers);
        });
    });
    glfwSetCharCallback(w, [](GLFWwindow* window, unsigned c) {
        on_event(window, [&](Viewer&) { ImGui_ImplGlfw_CharCallback(window, c); });
    });
    glfwSetWindowFocusCallback(w, [](GLFWwindow* window, int focused) {
        on_event(window, [&](Viewer&) { ImGui_ImplGlfw_WindowFocusCallback(window, focused); });
    });
    glfwSetCursorEnterCallback(w, [](GLFWwindow* window, int entered) {
        on_event(window, [&](Viewer&) { ImGui_ImplGlfw_CursorEnterCallback(window, entered); });
    });
    glfwSetDropCallback(w, [](GLFWwindow* window, int count, const char** files) {
        on_event(window, [&](Viewer& v) {
            if (count > 0) v.begin_opening(files[0]);
        });
    });
    glfwSetFramebufferSizeCallback(w, [](GLFWwindow* window, int, int) {
        on_event(window, [](Viewer& v) { v.redraw(); });  // also while the frame is being dragged
    });
    glfwSetWindowRefreshCallback(w, [](GLFWwindow* window) { on_event(window, [](Viewer&) {}); });
    glfwSetWindowContentScaleCallback(w, [](GLFWwindow* window, float, float) { on_event(window, [](Viewer&) {}); });
}

void Viewer::on_key(int key, int modifiers) {
    const bool control = (modifiers & GLFW_MOD_CONTROL) != 0, shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    if (key == GLFW_KEY_F1) return gui_.interface.toggle_help();
    if (key == GLFW_KEY_F11) return window_.toggle_full_screen();
    if (key == GLFW_KEY_F5) return present(!gui_.interface.presenting());
    if (pointer_.busy() || gui_.interface.dialog_shown()) return;
    if (gui_.wants_keyboard()) {
        if (!control || !leaves_a_field(key)) return;
        gui_.finish_typing();
    }
    commit();
    const bool exercising = gui_.interface.exercising();  // what is asked must stay what it is
    if (control) {
        switch (key) {
            case GLFW_KEY_Z: return undo(shift);
            case GLFW_KEY_Y: return undo(true);
            case GLFW_KEY_O: return gui_.interface.ask_open(scene_);
            case GLFW_KEY_S: return gui_.interface.ask_save_scene();
            case GLFW_KEY_F:
                if (!exercising) gui_.interface.edit_formula(scene_);
                return;
            case GLFW_KEY_P: return gui_.interface.ask_save_picture();
            case GLFW_KEY_C: return copy_command();
            case GLFW_KEY_L: return shift ? copy_equations() : copy_link();
            case GLFW_KEY_V: return paste();
            case GLFW_KEY_EQUAL:
            case GLFW_KEY_KP_ADD: return change_scale(+1);
            case GLFW_KEY_MINUS:
            case GLFW_KEY_KP_SUBTRACT: return change_scale(-1);
            case GLFW_KEY_0:
            case GLFW_KEY_KP_0: return change_scale(0);
            case GLFW_KEY_Q: return glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
            default: return;
        }
    }
    if (press_view_key(scene_, key) || (!exercising && press_object_key(scene_, key))) return;
    switch (key) {
        case GLFW_KEY_M:
            if (gui_.interface.presenting()) window_.to_next_monitor();
            break;
        case GLFW_KEY_TAB:
        case GLFW_KEY_H: gui_.interface.toggle_panel(); break;
        case GLFW_KEY_F:
            if (const auto ball = surface_ball()) scene_.camera = framed(scene_.camera, ball->centre, ball->radius);
            break;
        default: break;
    }
}

std::optional<WorldBall> Viewer::surface_ball() const {
    if (!frame_ || frame_->surface->mesh.positions.empty()) return std::nullopt;
    WorldBall ball = bounding_ball(frame_->surface->mesh, world_from_object(scene_));
    ball.radius += 2.0 * scene_.arrows.length;
    return ball;
}

Frame Viewer::frame_now(bool handles) {
    const auto make = [&] {
        const std::shared_ptr<const Surface> surface = surfaces_->get(scene_);
        const Quality quality = !handles                           ? Quality::Fine
                                : gui_.interface.typing_formula()  ? Quality::Sketch
                                : pointer_.busy() || gui_.moving() ? Quality::Draft
                                                                   : Quality::Fine;
        Frame frame = make_frame(shown_scene(), surface,
                                 {.rect = gui_.interface.picture(window_.framebuffer_size()),
                                  .pixel_scale = scale(),
                                  .hot_axis = pointer_.hot_axis(),
                                  .highlight = gui_.interface.highlighted(),
                                  .handles = handles,
                                  .quality = quality,
                                  .level_sets = level_sets_.get(scene_, surface->implicit)});
        gui_.interface.add_to(frame, scene_, scale());
        return frame;
    };
    try {
        return make();
    } catch (const InputError& e) {  // the scene as it last was is still good
        gui_.interface.show_error(e.what());
        scene_ = history_.current();
        return make();
    }
}

Requests Viewer::lay_out() {
    Requests requests;
    const bool exercising = gui_.interface.exercising();
    gui_.layout(window_.framebuffer_size(), shown_scene().theme, scale(), [&] {
        requests = gui_.interface.draw(scene_, *frame_, {history_.can_undo(), history_.can_redo(), errors_, file_});
    });
    if (exercising && !gui_.interface.exercising()) {
        file_ = file_before_exercises_;
        set_title();
    }
    return requests;
}

bool Viewer::redraw() {
    const auto began = std::chrono::steady_clock::now();
    const glm::ivec2 size = window_.framebuffer_size();
    if (size.x < 1 || size.y < 1) return false;
    if (!target_ || target_->size() != size) {
        target_.reset();
        target_.emplace(size, kSamples);
        rough_target_.reset();
        drawn_.reset();
    }
    frame_ = frame_now(true);
    const Transform<World, Object> m = world_from_object(scene_);
    const std::optional<NormalMap> naive = normal_map(scene_, m, Rule::Naive);
    if (measured_surface_ != frame_->surface || measured_matrix_ != m.matrix() || measured_map_ != naive) {
        measured_surface_ = frame_->surface;
        measured_matrix_ = m.matrix();
        measured_map_ = naive;
        errors_ = naive ? error_statistics(frame_->surface->mesh, *naive, m.normal_matrices_by_rule()) : std::nullopt;
    }

    const Scene before = scene_;
    const Requests requests = lay_out();
    if (scene_ != before) {
        frame_ = frame_now(true);  // so that the picture follows the slider without a frame's delay
        frames_wanted_ = kFramesAfterEvent;
    }
    // While only the interface changes, as in a dialog, the samples still hold the picture.
    const bool quick = frame_->quality != Quality::Fine;
    const bool rough = pace_.rough(quick) || (quick && frame_->surface->implicit);
    const Drawn now{
        shown_scene(),   frame_->surface, frame_->rect,          pointer_.hot_axis(), gui_.interface.highlighted(),
        frame_->quality, rough,           gui_.interface.guess()};
    if (rough && !rough_target_) rough_target_.emplace(size, 1);
    Target& target = rough ? *rough_target_ : *target_;
    renderer_.coarsen_drafts(pace_.coarse());
    if (drawn_ != now)
        renderer_.draw(*frame_, target);
    else
        renderer_.draw_again(*frame_, target);
    drawn_ = now;
    gui_.draw();
    if (quick) {
        Target::finish();  // swapping waits for the screen besides
        pace_.took(std::chrono::steady_clock::now() - began);
    }
    target.show();
    glfwSwapBuffers(window_.handle());

    obey(requests);
    if (!pointer_.scrolled()) commit_if_finished();
    if (gui_.has_more_input()) frames_wanted_ = std::max(frames_wanted_, 1);
    return true;
}

void Viewer::obey(const Requests& requests) {
    if (requests.make_room)
        if (const auto ball = surface_ball()) scene_.camera = with_room_for(scene_.camera, ball->centre, ball->radius);
    if (requests.step) commit();
    if (requests.undo || requests.redo) undo(requests.redo);
    if (requests.full_screen) window_.toggle_full_screen();
    if (requests.end_presenting) present(false);
    if (requests.copy_link) copy_link();
    if (requests.copy_equations) copy_equations();
    if (requests.quit) glfwSetWindowShouldClose(window_.handle(), GLFW_TRUE);
    if (requests.open) begin_opening(*requests.open);
    if (requests.open_mesh) begin_opening(*requests.open_mesh);
    try {
        if (requests.save_scene) {
            save_scene(scene_, *requests.save_scene);
            file_ = requests.save_scene->string();
            set_title();
            gui_.interface.show_note("Saved " + file_);
        }
        if (requests.save_picture) save_picture(*requests.save_picture);
        if (requests.copy_command) copy_command();
    } catch (const Error& e) {
        gui_.interface.show_error(e.what());
    }
}

void Viewer::undo(bool redo) {
    if (gui_.interface.exercising()) return;
    commit();
    show(redo ? history_.redo() : history_.undo());
}

void Viewer::copy_link() {
    glfwSetClipboardString(window_.handle(), link_of(scene_).c_str());
    const auto* mesh = std::get_if<MeshSurface>(&scene_.surface);
    gui_.interface.show_note(mesh ? "Copied a link to this scene. It names " + mesh->mesh +
                                        " but does not hold it: whoever opens the link needs that file there"
                                  : "Copied a link to this scene: paste it with Ctrl+V, or give it as FILE");
}

void Viewer::copy_equations() {
    const auto probe = frame_ && frame_->probe ? std::optional(frame_->probe->object) : std::nullopt;
    glfwSetClipboardString(window_.handle(), equations_latex(explanation(scene_, probe)).c_str());
    gui_.interface.show_note("Copied the equations as LaTeX (packages amsmath and color)");
}

void Viewer::paste() {
    const char* text = glfwGetClipboardString(window_.handle());
    if (!text || !is_link(text))
        return gui_.interface.show_note("The clipboard holds no link; one begins with normalscope:");
    begin_opening(text);
}

void Viewer::begin_opening(const std::string& file) {
    if (opening_.valid()) return gui_.interface.show_note("Still reading a file");
    // In another thread: the window stays alive while a large mesh is read.
    opening_ = std::async(std::launch::async, [file, scene = gui_.interface.scene_before_exercises(scene_)] {
        return open_file(file, scene);
    });
    if (opening_.wait_for(std::chrono::milliseconds(150)) != std::future_status::ready)
        gui_.interface.show_note("Reading " + short_name(file) + " \u2026");
}

void Viewer::finish_opening() {
    if (!opening_.valid() || opening_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    frames_wanted_ = kFramesAfterEvent;
    try {
        Opened opened = opening_.get();
        commit();
        if (opened.exercises) {
            if (!gui_.interface.exercising()) file_before_exercises_ = file_;
            file_ = opened.file;
            gui_.interface.start_exercises(*opened.exercises, scene_);
            return set_title();
        }
        if (opened.lesson) {
            surfaces_ = std::move(opened.surfaces);
            file_ = opened.lesson->name;
            gui_.interface.open_lesson(std::move(opened.lesson), scene_, opened.step);
            return set_title();
        }
        gui_.interface.end_exercises();
        opened.scene.theme = scene_.theme;  // the room's light does not change with the scene
        scene_ = std::move(opened.scene);
        surfaces_ = std::move(opened.surfaces);
        file_ = is_link(opened.file) ? "" : std::move(opened.file);
        set_title();
    } catch (const Error& e) {
        gui_.interface.show_error(e.what());
    }
}

void Viewer::copy_command() {
    const glm::ivec2 size = gui_.interface.picture(window_.framebuffer_size()).size;
    glfwSetClipboardString(window_.handle(), capture_command(scene_, file_, size, window_.content_scale()).c_str());
    gui_.interface.show_note("Copied the command that draws this picture");
}

void Viewer::save_picture(const std::filesystem::path& file) {
    const glm::ivec2 size = window_.framebuffer_size();
    if (file.extension() == ".svg") {
        const PixelRect rect{{0, 0}, gui_.interface.picture(size).size};
        const Frame vectors =
            make_frame(shown_scene(), surfaces_->get(scene_), {.rect = rect, .pixel_scale = scale(), .handles = false});
        write_file(file, svg_text(shown_scene(), vectors, scale(), Ground::Scene));
        return gui_.interface.show_note("Saved " + file.string());
    }
    const Frame frame = frame_now(false);
    gui_.layout(size, shown_scene().theme, scale(), [&] { gui_.interface.draw_words(frame); });
    drawn_.reset();
    renderer_.draw(frame, *target_);
    gui_.draw();
    write_png(file, cropped(target_->read(), frame.rect.origin, frame.rect.size));
    gui_.interface.show_note("Saved " + file.string());
    frames_wanted_ = kFramesAfterEvent;
}

void Viewer::wait() {
    double seconds = gui_.interface.redraw_after();
    if (opening_.valid()) seconds = std::min(seconds, 0.05);
    if (frames_wanted_ > 0)
        glfwPollEvents();
    else if (std::isfinite(seconds)) {
        glfwWaitEventsTimeout(std::max(seconds, 0.001));
        frames_wanted_ = std::max(frames_wanted_, 1);
    } else
        glfwWaitEvents();
}

void Viewer::run() {
    redraw();  // before any event: what one means depends on what is on the screen
    while (!glfwWindowShouldClose(window_.handle())) {
        wait();
        finish_opening();
        if (frames_wanted_ > 0) {
            --frames_wanted_;
            redraw();
        }
    }
}

}  // namespace

void run_viewer(Scene scene, const std::string& file) { Viewer(std::move(scene), file).run(); }

}  // namespace normalscope

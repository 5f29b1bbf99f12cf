#include "viewer/viewer.h"

#include "core/base/error.h"
#include "core/frame/picture_scale.h"
#include "core/lessons/open.h"
#include "core/picture/framing.h"
#include "core/picture/make_frame.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

namespace normalscope {

namespace {

// Dear ImGui settles over a few frames after an event: a hovered button lights up in the next one.
constexpr int kFramesAfterEvent = 3;
constexpr double kCarrying = 0.9;      // seconds from one space to the other, for the derivation's arrows
constexpr double kLookForFile = 0.05;  // seconds, while one is being read, or a surface made
constexpr double kKeepTyped = 2.0;     // seconds until what is being typed is safe from a crash

bool is_more_than_a_scene(const Opened& opened) { return opened.lesson || opened.exercises; }

}  // namespace

Viewer::Viewer(Host& host, Opened first, Remembered remembered)
    : host_(host),
      gui_(host),
      scale_(remembered.scale),
      document_(first.scene, is_more_than_a_scene(first) ? "" : first.file),
      frames_wanted_(kFramesAfterEvent),
      laid_out_at_(host.now()) {
    lecture().progress = std::move(remembered.lessons);
    set_motion(remembered.motion);
    if (is_more_than_a_scene(first))
        take(std::move(first));
    else
        surfaces_.take(std::move(first.surfaces));
    show_title();
    gui_.interface.unfolded() = remembered.unfolded;
    gui_.interface.recent_files() = std::move(remembered.recent_files);
    note_file(document_.file());
    offered_ = std::move(remembered.unsaved);
    go_on_with_what_is_shown();
    if (remembered.first && motion_ && (document_.file().empty() || document_.file() == kDefaultScene) &&
        !exercising() && !lecture().player.running())
        greeting_ = true, gui_.interface.play(document_.scene);
    if (!offered_.empty()) offer();
}

void Viewer::set_motion(bool moves) { motion_ = lecture().player.moves = moves; }

Remembered Viewer::remembered() const {
    return {.scale = scale_,
            .lessons = lecture().progress,
            .unfolded = gui_.interface.unfolded(),
            .recent_files = gui_.interface.recent_files(),
            .first = false,
            .motion = motion_};
}

Scene Viewer::shown_scene() const {
    Scene scene = document_.scene;
    if (presenting()) scene.theme = theme_of(is_dark(scene.theme), true);
    return scene;
}

std::optional<Swing::Powers> Viewer::swinging() const {
    return swing_ ? swing_->at(host_.now(), document_.scene) : std::nullopt;
}

StepMarks Viewer::step_marks(Marks marks) const {
    StepMarks shown = gui_.interface.marks();
    if (shown.line && marks == Marks::WithHandles && carrying_since_) {
        const double t = std::clamp((host_.now() - *carrying_since_) / kCarrying, 0.0, 1.0);
        shown.line->carried = t * t * (3.0 - 2.0 * t);
    }
    return shown;
}

float Viewer::scale() const { return scale_.of(host_.content_scale(), host_.framebuffer_size(), presenting()); }

std::optional<WorldBall> Viewer::surface_ball() const {
    if (!frame_ || frame_->surface->mesh.positions.empty()) return std::nullopt;
    WorldBall ball = bounding_ball(frame_->surface->mesh, world_from_object(document_.scene));
    const double unit = picture_unit(*frame_->surface, world_from_object(document_.scene));
    ball.radius += 2.0 * unit * document_.scene.arrows.length;
    return ball;
}

void Viewer::frame_surface() {
    const auto ball = surface_ball();
    if (!ball) return;
    document_.scene.camera.target = ball->centre;
    document_.scene.camera.zoom = framing_zoom(document_.scene, *frame_->surface);
}

void Viewer::wake() { frames_wanted_ = kFramesAfterEvent; }

void Viewer::end_greeting() {
    if (std::exchange(greeting_, false)) gui_.interface.finish_playing(document_.scene);
}

bool Viewer::end_path() {
    LessonPlayer& player = lecture().player;
    if (!player.running() || !player.on_path()) return false;
    player.arrive(document_.scene);
    return true;
}

double Viewer::due() const {
    if (frames_wanted_ > 0 || swing_ || carrying_since_) return 0.0;
    double wait = std::max(wake_at() - host_.now(), 0.0);
    if (lesson_is_watched()) wait = std::min(wait, std::max(watch_.due() - host_.now(), 0.0));
    if (keep_due_) wait = std::min(wait, std::max(*keep_due_ - host_.now(), 0.0));
    return opening_ || surfaces_.making() ? std::min(wait, kLookForFile) : wait;
}

void Viewer::step() {
    if (opening_ || swing_ || carrying_since_ || surfaces_.making()) frames_wanted_ = std::max(frames_wanted_, 1);
    if (!swinging()) swing_.reset();
    if (carrying_since_ && host_.now() - *carrying_since_ >= kCarrying) carrying_since_.reset();
    finish_opening();
    watch_lesson();
    if (keep_due_ && host_.now() >= *keep_due_) keep(document_.all_unsaved());
    if (host_.now() >= wake_at()) frames_wanted_ = std::max(frames_wanted_, 1);
    if (frames_wanted_ == 0) return;
    --frames_wanted_;
    draw();
}

// Until the interface knows of all input so far: whose the next press is depends on what lies under the pointer by now, and
// on whether something is being typed.
void Viewer::catch_up() {
    while (gui_.has_more_input()) {
        // What is typed into a formula is not made letter by letter where letters come faster than pictures.
        if (!has_room()) return;
        obey(frame_ && gui_.interface.typing_formula() ? lay_out() : compose());
        if (!pointer_.scrolled()) commit_if_finished();
    }
}

bool Viewer::can_be_drawn(const Scene& scene) {
    try {
        return surfaces_.get(scene).surface != nullptr;
    } catch (const InputError& e) {
        gui_.interface.show_error(e.what());
        return false;
    }
}

Frame Viewer::frame_now(Marks marks) {
    const auto make = [&] {
        const auto& [scene, surface] = marks == Marks::AsSaved
                                           ? SurfaceInTime::Shown{document_.scene, surfaces_.get_now(document_.scene)}
                                           : surfaces_.get(document_.scene);
        const auto swing = marks == Marks::AsSaved ? std::nullopt : swinging();
        Scene seen = shown_scene();
        seen.surface = scene.surface;
        if (swing) seen.power = swing->naive;
        const Quality quality = marks == Marks::AsSaved                                        ? Quality::Fine
                                : gui_.interface.typing_formula()                              ? Quality::Sketch
                                : pointer_.busy() || gui_.moving() || swing || carrying_since_ ? Quality::Draft
                                                                                               : Quality::Fine;
        Frame frame = make_frame(seen, surface,
                                 {.rect = gui_.interface.picture(host_.framebuffer_size()),
                                  .pixel_scale = scale(),
                                  .hot_axis = pointer_.hot_axis(),
                                  .highlight = gui_.interface.highlighted(),
                                  .handles = marks == Marks::WithHandles,
                                  .quality = quality,
                                  .level_sets = level_sets_.get(scene, surface->implicit),
                                  .marks = step_marks(marks),
                                  .flat_cut = flat_cut_.get(scene, surface),
                                  .right_power = swing.value_or(Swing::Powers{}).right});
        lecture().exercises.add_to(frame, document_.scene, scale());
        return frame;
    };
    try {
        return make();
    } catch (const InputError& e) {  // the scene as it last was is still good
        gui_.interface.show_error(e.what());
        document_.go_back_to_last();
        return make();
    }
}

Requests Viewer::lay_out() {
    Requests requests;
    const bool was_exercising = exercising(), was_in_lesson = in_lesson();
    const std::optional<ErrorStatistics>& errors = errors_.get(document_.scene, frame_->surface);
    gui_.layout(shown_scene().theme, scale(), [&] {
        requests = gui_.interface.draw(document_.scene, *frame_,
                                       {.can_undo = document_.can_undo(),
                                        .can_redo = document_.can_redo(),
                                        .errors = errors,
                                        .file = document_.file(),
                                        .has_file = document_.has_file(),
                                        .by_hand = true,
                                        .in_lesson = in_lesson(),
                                        .draft = document_.draft,
                                        .unsaved_lesson = document_.unsaved_lesson(),
                                        .as_named = document_.as_named()});
    });
    laid_out_at_ = host_.now();
    if (was_exercising && !exercising()) document_.set_origin(origin_before_exercises_);
    if (was_in_lesson && !in_lesson()) document_.leave_lesson();
    if (document_.draft.lesson) document_.draft.step = lecture().player.number();
    // From whatever else was opened meanwhile, the lesson goes on.
    if (lecture().moving() && !in_lesson()) document_.play(lecture().player.lesson().name);
    return requests;
}

bool Viewer::has_room() const { return glm::all(glm::greaterThan(host_.framebuffer_size(), glm::ivec2(0))); }

Requests Viewer::compose() {
    frame_ = frame_now(Marks::WithHandles);
    tell_of_waiting();
    tell_of_lost_object();
    const Scene before = document_.scene;
    const std::optional<Highlight> lit = gui_.interface.highlighted();
    const Requests requests = lay_out();
    const auto line = gui_.interface.marks().line;
    const bool other_line = line != line_;
    if (other_line) {
        line_ = line;
        carrying_since_ = motion_ && line && carries(line->line) ? std::optional(host_.now()) : std::nullopt;
    }
    if (document_.scene != before || gui_.interface.highlighted() != lit || other_line) {
        frame_ =
            frame_now(Marks::WithHandles);  // so that the picture follows slider and pointer without a frame's delay
        wake();
    }
    return requests;
}

void Viewer::draw() {
    if (!has_room()) return;
    if (gui_.interface.asks_for_file() && host_.choose_file()) gui_.interface.ask_no_more();
    const auto began = std::chrono::steady_clock::now();
    const Requests requests = compose();
    // While only the interface changes, as in a dialog, the samples still hold the picture.
    const bool quick = frame_->quality != Quality::Fine;
    const bool rough = pace_.rough(quick) || (quick && frame_->surface->implicit);
    const auto arrow = exercising() ? std::optional(lecture().exercises.arrow()) : std::nullopt;
    Drawn now{host_.framebuffer_size(),
              shown_scene(),
              frame_->surface,
              frame_->rect,
              pointer_.hot_axis(),
              gui_.interface.highlighted(),
              frame_->quality,
              rough,
              -1.0,
              step_marks(Marks::WithHandles),
              arrow};
    if (const auto swing = swinging()) now.scene.power = swing->naive, now.right_power = swing->right;
    host_.draw({*frame_, drawn_ != now, rough, pace_.coarse(), quick});
    drawn_ = now;
    if (quick) pace_.took(std::chrono::steady_clock::now() - began);
    host_.show();

    obey(requests);
    if (!pointer_.scrolled()) commit_if_finished();
    show_title();
    if (!pointer_.busy() && !gui_.editing())
        keep(document_.all_unsaved());
    else if (gui_.wants_keyboard() && !keep_due_)
        keep_due_ = host_.now() + kKeepTyped;  // somebody may go from field to field for minutes
    if (!gui_.interface.dialog_shown()) closes_when_saved_ = false;
    if (gui_.has_more_input()) frames_wanted_ = std::max(frames_wanted_, 1);
}

void Viewer::obey(const Requests& requests) {
    wants_room_ = wants_room_ || requests.make_room;
    if (wants_room_ && !surfaces_.making()) {
        if (const auto ball = surface_ball(); ball && !has_room_for(document_.scene.camera, ball->centre, ball->radius))
            frame_surface();
        wants_room_ = false;
    }
    if (requests.step) commit();
    if (requests.rule) choose(*requests.rule);
    if (requests.undo || requests.redo) undo(requests.redo ? Direction::Redo : Direction::Undo);
    if (requests.full_screen) host_.toggle_full_screen();
    if (requests.end_presenting) present(false);
    if (requests.copy_link) copy_link();
    if (requests.copy_frame) copy_frame();
    if (requests.copy_equations) copy_equations();
    if (requests.quit) close();
    if (requests.reply) obey(*requests.reply);
    if (requests.edit) write(*requests.edit);
    if (requests.writing) write(*requests.writing);
    if (requests.save_lesson_as) ask_save_lesson();
    if (requests.list_lessons) list_lessons();
    if (requests.open) open(*requests.open);
    if (requests.open_mesh) open(*requests.open_mesh);
    try {
        if (requests.save) save();
        if (requests.save_lesson) save_lesson(*requests.save_lesson);
        if (requests.save_scene) save_scene(*requests.save_scene);
        if (requests.save_picture) save_picture(*requests.save_picture);
        if (requests.copy_command) copy_command();
    } catch (const Error& e) {
        gui_.interface.show_error(e.what());
    }
}

}  // namespace normalscope

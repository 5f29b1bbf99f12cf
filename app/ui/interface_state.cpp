#include "ui/interface_state.h"

#include "core/lessons/scene_caption.h"
#include "ui/lecture/lesson_letters.h"
#include "ui/scene_strip.h"
#include "ui/tabs/ray_tab.h"

#include <algorithm>

namespace normalscope {

namespace {

constexpr double kLater = 1.0;  // seconds, after presenting

}  // namespace

// The window draws only when something happens, but a tooltip comes some time after the pointer has come to rest, and
// the ground of a dialog darkens step by step.
void InterfaceState::watch_the_clock() {
    const ImGuiIO& io = ImGui::GetIO();
    const double now = ImGui::GetTime();
    if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f) pointer_rested = now;
    const bool any_popup = asks();
    if (any_popup != popup) popups_changed = now;
    popup = any_popup;

    wake = messages.redraw_after();
    const double tooltips = ImGui::GetStyle().HoverDelayNormal + ImGui::GetStyle().HoverStationaryDelay + 0.1;
    if (ImGui::IsAnyItemHovered() && now - pointer_rested < tooltips) wake = std::min(wake, 0.1);
    if (lecture.presenting && now - pointer_rested < kPointerShown + 0.1)
        wake = std::min(wake, std::max(pointer_rested + kPointerShown + 0.05 - now, 0.05));
    if (now - popups_changed < 0.3) wake = std::min(wake, 1.0 / 30.0);
    if (letters.pending()) wake = 0.0;
    if (stack.player.playing || lecture.moving()) wake = 0.0;
    wake = std::min(wake, panel.formula.redraw_after());
    if (panel.gallery.previews.needs_room()) wake = 0.0;
    if (panel.gallery.previews.busy()) wake = std::min(wake, 0.1);
}

void InterfaceState::ask_to_leave_lesson(const Status& status) {
    question.ask(Asked::LeavingLesson, "Leave the lesson?",
                 status.unsaved_lesson ? "It is not saved; Ctrl+Z brings it back."
                                       : "The scene stays open, for you to play with.",
                 {"Leave", "Stay"});
}

void InterfaceState::leave_lecture(Scene& scene, const Status& status) {
    if (lecture.exercises.running() && lecture.exercises.has_score())
        question.ask(Asked::LeavingLesson, "Leave the exercises?",
                     "You have " + lecture.exercises.score() + ", which will be lost.", {"Leave", "Stay"});
    else if (lecture.player.running() && status.unsaved_lesson)
        ask_to_leave_lesson(status);
    else
        lecture.leave(scene);
}

void InterfaceState::leave_one_thing(Scene& scene, const Status& status, Requests& requests) {
    if (lecture.presenting) {
        requests.end_presenting = true;
        presented_until = ImGui::GetTime();
    } else if (side.open && !lecture.exercises.running()) {
        side.open.reset();
    } else if (!lecture.player.running()) {
        leave_lecture(scene, status);
    } else if (ImGui::GetTime() - presented_until > kLater) {
        ask_to_leave_lesson(status);
    }
}

std::vector<SideTab> InterfaceState::tabs() {
    const auto drawing = [this](std::string_view tab) -> decltype(SideTab::draw) {
        if (tab == "stack")
            return [this](Scene& scene, const SideContext& context) { draw_stack_tab(scene, stack, context); };
        if (tab == "maps")
            return [this](Scene& scene, const SideContext& context) { draw_maps_tab(scene, maps, context); };
        if (tab == "error")
            return [this](Scene& scene, const SideContext& context) { draw_error_tab(scene, error, context); };
        if (tab == "ray") return draw_ray_tab;
        return {};  // the derivation has a window of its own
    };
    std::vector<SideTab> tabs;
    for (const Tab& tab : kTabs)
        tabs.push_back({tab.name, tab.label, tab.about, tab.at_first, drawing(tab.name),
                        tab.name == "ray" ? draw_ray_head : nullptr});
    return tabs;
}

Arrangement InterfaceState::arrangement(glm::ivec2 framebuffer) const {
    std::optional<float> tab;
    if (side.open)
        tab = side.open == kDerivation ? derivation.width() : kSideWidth;
    else if (edits())
        tab = kEditorWidth;
    return arrange(look, framebuffer,
                   {.panel = is_drawer(look, framebuffer) ? drawer_open : panel_shown,
                    .lecture = lecture.talks(),
                    .presenting = lecture.presenting,
                    .exercising = lecture.exercises.running(),
                    .tab = tab});
}

void InterfaceState::draw_strip(Scene& scene, const Frame& frame, const Status& status, Requests& requests) {
    const bool about = !scene.about.empty() && status.as_named;
    const bool stopped = scene.stack_position && !stack.player.playing;
    const bool nothing = frame.surface && frame.surface->implicit && !frame.surface->implicit->region() &&
                         frame.surface->mesh.triangles.empty();
    const std::string sentence = nothing   ? "No surface is drawn: the note below the formula says why."
                                 : stopped ? "Stopped partway: " + how_far(scene)
                                 : about   ? said_of(scene).caption
                                           : said_of_m(scene);
    letters.want(sentence, look.fonts.title);
    switch (draw_scene_strip(
        look, {.sentence = sentence, .plays = !scene.stack.empty(), .playing = stack.player.playing}, frame.rect)) {
        case StripPress::None: break;
        case StripPress::Play: toggle(stack.player, scene); break;
        case StripPress::Why: ask_why(scene); break;
        case StripPress::TryIt: requests.open = "exercises"; break;
    }
}

void InterfaceState::draw_editor(const Scene& scene, const Frame& frame, const Status& status, Requests& requests) {
    writing = status.draft.lesson != nullptr;
    if (edits()) {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        const int width = side.open ? 0 : arrangement(glm::ivec2(screen.x, screen.y)).side;
        editor.draw({look, status.draft, scene, frame.rect, lecture.player.strayed(scene), static_cast<float>(width)},
                    requests);
    }
    if (requests.writing) editor_shown = *requests.writing != Writing::Done;
}

// Where the naive rule's arrow is seen, what becomes of its dot product; else the line at which the right one follows, or stops.
void InterfaceState::ask_why(const Scene& scene) {
    const bool invertible = world_from_object(scene).normal_matrices_by_rule().rank == 3;
    side.open = kDerivation;
    const bool naive = scene.rule == Rule::Naive || scene.view != ViewMode::Single;
    const DerivationLine right = invertible ? DerivationLine::Rule : DerivationLine::Solved;
    derivation.step_from(naive && invertible ? kDerivationLines : static_cast<std::size_t>(right));
}

// A lecturer may write in any script.
void InterfaceState::want_letters_of_lesson() {
    if (!look.fonts.body || !lecture.player.running() || lettered.lock() == lecture.player.shared_lesson()) return;
    const std::shared_ptr<const Lesson> lesson = lecture.player.shared_lesson();
    lettered = lesson;
    want_letters_of(*lesson, letters, look.fonts.body);
}

}  // namespace normalscope

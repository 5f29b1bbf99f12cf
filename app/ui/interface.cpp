#include "ui/interface.h"

#include "core/base/error.h"
#include "core/lessons/tabs.h"
#include "ui/help.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/messages.h"
#include "ui/kit/picture_labels.h"
#include "ui/kit/question.h"
#include "ui/kit/side_panel.h"
#include "ui/lecture/lesson_letters.h"
#include "ui/panel/drawer.h"
#include "ui/panel/panel.h"
#include "ui/panel/panel_memory.h"
#include "ui/probe_trail.h"
#include "ui/tabs/derivation_panel.h"
#include "ui/tabs/error_tab.h"
#include "ui/tabs/maps_tab.h"
#include "ui/tabs/ray_tab.h"
#include "ui/tabs/stack_tab.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

struct Interface::State {
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
    mutable Lecture lecture;  // which remembers what it has measured
    bool captions = false;    ///< their fonts are in the atlas
    bool panel_shown = true, help = false;
    double wake = std::numeric_limits<double>::infinity();
    double pointer_rested = 0.0;  ///< since when, by ImGui::GetTime
    double popups_changed = -1e9, presented_until = -1e9;
    bool popup = false;

    void watch_the_clock();
    /// A dialog is open, or will be in the next frame.
    bool asks() const { return dialog.is_open() || question.is_open(); }
    /// Presenting first; a lesson only when asked again, and later: a key that bounces ends no lecture.
    void leave_one_thing(Scene& scene, Requests& requests);
    std::vector<SideTab> tabs();
    /// Not for a room; nor in an exercise, whose answer it would tell; nor where it and the tab that a lesson opens would
    /// leave too little of the picture.
    bool shows_panel(glm::ivec2 framebuffer) const;
    /// The panel is a drawer below the picture, open or not.
    bool has_drawer(glm::ivec2 framebuffer) const;
    void want_letters_of_lesson();
    /// How much of the framebuffer's width the open tab takes.
    int side_width(int framebuffer) const;
};

namespace {

constexpr double kPointerShown = 4.0;  // seconds, after it has come to rest
constexpr double kLater = 1.0;         // seconds, after presenting
constexpr std::size_t kDerivation = 0;
static_assert(kTabs[kDerivation].name == "derivation");

// In a window hardly wider than what stands beside the picture, that covers part of it rather than all.
constexpr float kNarrowestPicture = 240.0f;  // beside panel and tab; else the panel makes room
constexpr float kLeastPicture = 120.0f;      // beside a tab

// What can be done to a scene without a product that overflows; the last stack is kept otherwise.
void undo_overflow(Scene& scene, std::vector<StackEntry>& before, Messages& messages) {
    try {
        (void)world_from_object(scene);
    } catch (const InputError& error) {
        scene.stack = std::move(before);
        messages.show_error(error.what());
    }
}

}  // namespace

// The window draws only when something happens, but a tooltip comes some time after the pointer has come to rest, and
// the ground of a dialog darkens step by step.
void Interface::State::watch_the_clock() {
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

void Interface::State::leave_one_thing(Scene& scene, Requests& requests) {
    if (lecture.presenting) {
        requests.end_presenting = true;
        presented_until = ImGui::GetTime();
    } else if (!lecture.player.running()) {
        lecture.leave(scene);
    } else if (ImGui::GetTime() - presented_until > kLater) {
        question.ask(Asked::LeavingLesson, "Leave the lesson?", "The step stays, to be played with.",
                     {"Leave", "Stay"});
    }
}

std::vector<SideTab> Interface::State::tabs() {
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
        tabs.push_back(
            {tab.name, tab.label, tab.about, drawing(tab.name), tab.name == "ray" ? draw_ray_head : nullptr});
    return tabs;
}

bool Interface::State::shows_panel(glm::ivec2 framebuffer) const {
    if (!panel_shown || lecture.presenting || lecture.exercises.running()) return false;
    // Where both leave hardly a picture, the tab that was opened is what one wants to see; closing it is one press.
    if (is_drawer(look, framebuffer)) return has_drawer(framebuffer);
    const int beside = side_width(framebuffer.x);
    return beside == 0 || framebuffer.x - static_cast<int>(look.px(kPanelWidth)) - beside >=
                              static_cast<int>(look.px(kNarrowestPicture));
}

// Where words are below the picture, or another panel is over it, there is no room for it.
bool Interface::State::has_drawer(glm::ivec2 framebuffer) const {
    return is_drawer(look, framebuffer) && !lecture.talks() && !side.open;
}

// A lecturer may write in any script.
void Interface::State::want_letters_of_lesson() {
    if (!look.fonts.body || !lecture.player.running() || lettered.lock() == lecture.player.shared_lesson()) return;
    const std::shared_ptr<const Lesson> lesson = lecture.player.shared_lesson();
    lettered = lesson;
    want_letters_of(*lesson, letters, look.fonts.body);
}

int Interface::State::side_width(int framebuffer) const {
    if (!side.open || lecture.exercises.running()) return 0;
    return std::min(static_cast<int>(look.px(side.open == kDerivation ? kDerivationWidth : kSideWidth)), framebuffer);
}

Interface::Interface() : state_{std::make_unique<State>()} {}
Interface::~Interface() = default;
Interface::Interface(Interface&&) noexcept = default;
Interface& Interface::operator=(Interface&&) noexcept = default;

bool Interface::prepare(Theme theme, float scale) {
    Look& look = state_->look;
    scale = std::clamp(scale, 0.5f, 8.0f);
    const bool first = !look.fonts.body, scaled = first || scale != look.scale;
    if (first) {
        ImGuiIO& io = ImGui::GetIO();
        io.ConfigFlags |= ImGuiConfigFlags_NavNoCaptureKeyboard;
        io.ConfigDragClickToInputText = true;
        io.ConfigInputTextCursorBlink = false;  // a blinking cursor would redraw an idle window
        io.IniFilename = io.LogFilename = nullptr;
    }
    // Whoever presents has a remote control, whose keys must not begin to wander from button to button.
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    if (!state_->lecture.presenting) flags |= ImGuiConfigFlags_NavEnableKeyboard;
    if (scaled || theme != look.theme) set_style(look, theme, scale);
    Previews& previews = state_->panel.gallery.previews;
    const bool captions = state_->lecture.talks();
    state_->want_letters_of_lesson();
    if (!scaled && !state_->letters.pending() && !previews.needs_room() && captions == state_->captions)
        return previews.update(*ImGui::GetIO().Fonts);
    state_->captions = captions;
    look.fonts = build_fonts(scale, state_->letters, &previews, captions);
    state_->derivation.forget_layout();
    state_->lecture.forget_layout();
    if (first) (void)prepare(theme, scale);  // which letters are missing is known only by now
    return true;
}

void Interface::find_fonts_by(FindFonts find) { state_->letters.find_by(std::move(find)); }

PixelRect Interface::picture(glm::ivec2 framebuffer) const {
    const bool with_panel = state_->shows_panel(framebuffer);
    if (state_->has_drawer(framebuffer))
        return {{0, 0},
                {framebuffer.x, std::max(framebuffer.y - drawer_height(state_->look, framebuffer, with_panel), 1)}};
    const int panel = with_panel ? static_cast<int>(state_->look.px(kPanelWidth)) : 0;
    // In a window hardly wider than the panels, they cover part of the picture rather than all of it.
    const int left = framebuffer.x - panel >= panel / 4 ? panel : 0;
    const int side = state_->side_width(framebuffer.x);
    const int right = framebuffer.x - left - side >= static_cast<int>(state_->look.px(kLeastPicture)) ? side : 0;
    const int width = std::max(framebuffer.x - left - right, 1);
    const auto below = static_cast<int>(
        state_->lecture.strip_height(state_->look, static_cast<float>(width), static_cast<float>(framebuffer.y)));
    return {{left, 0}, {width, std::max(framebuffer.y - below, 1)}};
}

void Interface::key_was_pressed() { state_->look.tips = false; }

Requests Interface::draw(Scene& scene, const Frame& frame, const Status& status) {
    Requests requests;
    State& s = *state_;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f || ImGui::IsMouseDown(ImGuiMouseButton_Left))
        s.look.tips = true;
    std::vector<StackEntry> before = scene.stack;
    draw_words(frame);
    if (status.by_hand && !s.lecture.moving() && !s.lecture.exercises.running())
        s.trail.follow(scene, frame);
    else
        s.trail = {};
    s.trail.draw(s.look, frame);
    const std::vector<SideTab> tabs = s.tabs();
    if (const auto tab = s.lecture.wanted_tab()) show_tab(*tab);
    const auto strip_top = static_cast<float>(frame.rect.origin.y + frame.rect.size.y);
    s.lecture.draw(s.look, scene, {static_cast<float>(frame.rect.origin.x), strip_top},
                   {static_cast<float>(frame.rect.size.x), ImGui::GetIO().DisplaySize.y - strip_top});
    if (const auto lesson = s.lecture.wanted_lesson()) requests.open = lesson;
    s.dialog.set_scene_file(status.has_file ? status.file : "");
    const glm::ivec2 framebuffer(io.DisplaySize.x, io.DisplaySize.y);
    if (s.has_drawer(framebuffer) && drawer_handle(s.look, frame.rect, s.panel_shown)) s.panel_shown = !s.panel_shown;
    if (s.shows_panel(framebuffer))
        draw_panel(scene, s.panel,
                   {.look = s.look,
                    .frame = frame,
                    .place = panel_place(s.look, framebuffer),
                    .status = status,
                    .requests = requests,
                    .dialog = s.dialog,
                    .tabs = tabs,
                    .side = s.side,
                    .help = s.help});
    if (!s.lecture.exercises.running())
        draw_side_panel(scene, tabs, s.side, {.look = s.look, .frame = frame, .status = status},
                        static_cast<float>(s.side_width(static_cast<int>(ImGui::GetIO().DisplaySize.x))));
    if (!ImGui::GetIO().WantTextInput && !ImGui::IsAnyItemActive() && !s.asks() && !ImGui::GetIO().KeyMods &&
        ImGui::IsKeyPressed(ImGuiKey_D, false))
        show_derivation(!derivation_shown());
    advance(s.stack.player, scene);
    const bool help = s.help;
    draw_help(s.look, frame.rect, s.help);
    const bool asks = s.asks();  // Escape is theirs, also where it has closed them
    s.dialog.draw(s.look, s.letters, requests);
    s.question.draw(s.look, requests);
    if (!help && !asks && !ImGui::IsAnyItemActive() && ImGui::IsKeyPressed(ImGuiKey_Escape, false) &&
        !s.messages.dismiss()) {
        s.leave_one_thing(scene, requests);
    }
    if (requests.reply && requests.reply->asked == Asked::LeavingLesson) {
        if (requests.reply->choice == 0) s.lecture.leave(scene);
        requests.reply.reset();
    }
    if (scene.stack != before) undo_overflow(scene, before, s.messages);
    s.derivation.draw(s.look, scene, frame, derivation_shown() && !s.lecture.exercises.running(),
                      s.look.px(kTabsHeight));
    s.letters.want(s.messages.text(), s.look.fonts.body);
    s.letters.want(status.file, s.look.fonts.body);
    s.letters.want(s.panel.formula.draft.text, s.look.fonts.body);
    s.messages.draw(s.look, frame);
    s.lecture.draw_screen(s.look, ImGui::GetTime() - s.pointer_rested > kPointerShown);
    s.watch_the_clock();
    return requests;
}

void Interface::draw_words(const Frame& frame) const { normalscope::draw_words(state_->look, frame); }

void Interface::show_derivation(bool shown) {
    if (shown)
        state_->side.open = kDerivation;
    else if (derivation_shown())
        state_->side.open.reset();
}
bool Interface::derivation_shown() const { return state_->side.open == kDerivation; }
std::optional<DerivationAt> Interface::derivation_line() const {
    return derivation_shown() && !state_->lecture.exercises.running() ? state_->derivation.current() : std::nullopt;
}
std::optional<Highlight> Interface::highlighted() const { return state_->derivation.pointed_at(); }
void Interface::highlight(const std::optional<Highlight>& in_picture) { state_->derivation.highlight(in_picture); }

void Interface::show_error(std::string_view line) { state_->messages.show_error(line); }
void Interface::show_note(std::string_view line) { state_->messages.show_note(line); }
std::string_view Interface::message() const { return state_->messages.text(); }
double Interface::redraw_after() const { return std::min(state_->wake, state_->messages.redraw_after()); }

bool Interface::show_tab(std::string_view id) {
    const auto line = line_of_tab(id);
    if (line) id = kTabs[kDerivation].name;
    const auto found = std::ranges::find(kTabs, id, &Tab::name);
    if (found == kTabs.end() && !id.empty()) return false;
    state_->side.open.reset();
    if (!id.empty()) state_->side.open = static_cast<std::size_t>(found - kTabs.begin());
    if (line) state_->derivation.step_from(*line);
    return true;
}
bool Interface::typing_formula() const { return state_->panel.formula.typing(); }
bool Interface::playing() const { return state_->stack.player.playing || state_->lecture.moving(); }

Lecture& Interface::lecture() { return state_->lecture; }
const Lecture& Interface::lecture() const { return state_->lecture; }

void Interface::open_lesson(std::shared_ptr<const Lesson> lesson, const Scene& scene, std::optional<std::size_t> step) {
    state_->side.open.reset();  // the lesson opens what it wants
    state_->lecture.start(std::move(lesson), scene, step);
}
void Interface::record_lesson(std::shared_ptr<const Lesson> lesson, const Scene& scene, std::size_t step) {
    state_->lecture.recorded = state_->lecture.presenting = true;
    open_lesson(std::move(lesson), scene, step);
    if (const auto tab = state_->lecture.wanted_tab()) show_tab(*tab);
}
bool Interface::keys_are_free() const {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantTextInput && !io.NavVisible && !ImGui::IsAnyItemActive() && !state_->asks();
}

void Interface::edit_formula(Scene& scene) {
    if (!std::holds_alternative<FormulaSurface>(scene.surface)) scene.surface = state_->panel.formula.last;
    state_->panel.formula.focus = state_->panel_shown = true;
}
void Interface::toggle_help() { state_->help = !state_->help; }
void Interface::toggle_panel() { state_->panel_shown = !state_->panel_shown; }
bool Interface::panel_shown() const { return state_->panel_shown; }
void Interface::ask_open() { state_->dialog.open(FileDialog::For::OpenAny); }
bool Interface::asks_for_file() const { return state_->dialog.is_open() && state_->dialog.opens(); }
void Interface::ask_no_more() { state_->dialog.withdraw(); }
void Interface::ask_save_scene() { state_->dialog.open(FileDialog::For::SaveScene); }
void Interface::ask_save_picture() { state_->dialog.open(FileDialog::For::SavePicture); }
void Interface::ask(Asked what, std::string title, std::string text, std::vector<std::string> choices) {
    state_->question.ask(what, std::move(title), std::move(text), std::move(choices));
}
bool Interface::dialog_shown() const { return state_->asks(); }

}  // namespace normalscope

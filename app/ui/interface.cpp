#include "ui/interface.h"

#include "core/base/error.h"
#include "ui/help.h"
#include "ui/interface_state.h"
#include "ui/kit/picture_labels.h"
#include "ui/lecture/marks_of_step.h"
#include "ui/panel/drawer.h"
#include "ui/panel/panel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

namespace {

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

Interface::Interface() : state_{std::make_unique<InterfaceState>()} {}
Interface::~Interface() = default;
Interface::Interface(Interface&&) noexcept = default;
Interface& Interface::operator=(Interface&&) noexcept = default;

bool Interface::prepare(Theme theme, float scale) {
    Look& look = state_->look;
    scale = std::clamp(scale, 0.25f, 8.0f);
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
void Interface::draw_letters_by(DrawLetter draw) { state_->letters.draw_by(std::move(draw)); }

PixelRect Interface::picture(glm::ivec2 framebuffer) const {
    const Arrangement a = state_->arrangement(framebuffer);
    return a.drawer ? a.picture : state_->lecture.picture(state_->look, a.picture);
}

void Interface::key_was_pressed() { state_->look.tips = false; }

Requests Interface::draw(Scene& scene, const Frame& frame, const Status& status) {
    Requests requests;
    InterfaceState& s = *state_;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f || ImGui::IsMouseDown(ImGuiMouseButton_Left))
        s.look.tips = true;
    std::vector<StackEntry> before = scene.stack;
    draw_words(frame);
    if (status.by_hand && !s.lecture.presenting && !s.lecture.moving() && !s.lecture.exercises.running())
        s.trail.follow(scene, frame);
    else
        s.trail = {};
    s.trail.draw(s.look, frame);
    const std::vector<SideTab> tabs = s.tabs();
    if (const auto tab = s.lecture.wanted_tab()) show_tab(*tab);
    const glm::ivec2 framebuffer(io.DisplaySize.x, io.DisplaySize.y);
    s.lecture.draw(s.look, scene, s.arrangement(framebuffer).picture, frame.rect);
    if (const auto lesson = s.lecture.wanted_lesson()) requests.open = lesson;
    if (s.lecture.wants_to_end()) s.leave_lecture(scene, status);
    s.dialog.set_scene_file(status.has_file ? status.file : "");
    const Arrangement room = s.arrangement(framebuffer);
    if (room.drawer && drawer_handle(s.look, frame.rect, s.drawer_open)) s.drawer_open = !s.drawer_open;
    if (room.strip) s.draw_strip(scene, frame, status, requests);
    if (room.panel)
        draw_panel(scene, s.panel,
                   {.look = s.look,
                    .frame = frame,
                    .place = panel_place(s.look, framebuffer),
                    .status = status,
                    .requests = requests,
                    .dialog = s.dialog,
                    .tabs = tabs,
                    .side = s.side,
                    .help = s.help,
                    .unfolded = s.unfolded,
                    .asking = s.lecture.asking(),
                    .shelf = s.lecture.shelf.lessons,
                    .progress = s.lecture.progress});
    s.draw_editor(scene, frame, status, requests);
    if (!s.lecture.exercises.running())
        draw_side_panel(scene, tabs, s.side, {.look = s.look, .frame = frame, .status = status},
                        static_cast<float>(room.side));
    if (!ImGui::GetIO().WantTextInput && !ImGui::IsAnyItemActive() && !s.asks() && !ImGui::GetIO().KeyMods &&
        ImGui::IsKeyPressed(ImGuiKey_D, false))
        show_derivation(!derivation_shown());
    advance(s.stack.player, scene);
    const bool help = s.help;
    draw_help(s.look, frame.rect, s.help);
    // Escape is theirs, also where it has closed them; and an open menu's, and that of a field which it has left.
    const bool asks = s.asks();
    s.dialog.draw(s.look, s.letters, requests);
    s.question.draw(s.look, requests);
    if (!help && !asks && !s.menu_open && !s.item_active && !ImGui::IsAnyItemActive() &&
        ImGui::IsKeyPressed(ImGuiKey_Escape, false) && !s.messages.dismiss())
        s.leave_one_thing(scene, status, requests);
    if (requests.reply && requests.reply->asked == Asked::LeavingLesson) {
        if (requests.reply->choice == 0) s.lecture.leave(scene);
        requests.reply.reset();
    }
    if (scene.stack != before) undo_overflow(scene, before, s.messages);
    ImGui::PushStyleColor(ImGuiCol_ScrollbarGrab,
                          s.look.still ? ImVec4{} : ImGui::GetStyleColorVec4(ImGuiCol_ScrollbarGrab));
    const DerivationRoom place{s.look.px(kTabsHeight), s.shows_all_lines()};
    const bool derives = derivation_shown() && !s.lecture.exercises.running();
    s.derivation.draw(s.look, scene, frame, derives ? std::optional(place) : std::nullopt);
    ImGui::PopStyleColor();
    s.letters.want(s.messages.text(), s.look.fonts.body);
    s.letters.want(status.file, s.look.fonts.body);
    s.letters.want(s.panel.formula.draft.text, s.look.fonts.body);
    s.messages.draw(s.look, frame);
    s.lecture.draw_screen(s.look, ImGui::GetTime() - s.pointer_rested > kPointerShown);
    s.watch_the_clock();
    s.menu_open = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    s.item_active = ImGui::IsAnyItemActive();
    return requests;
}

void Interface::draw_words(const Frame& frame) const { normalscope::draw_words(state_->look, frame); }
std::vector<PixelRect> Interface::word_boxes(const Frame& frame) const {
    return normalscope::word_boxes(state_->look, frame);
}

void Interface::show_derivation(bool shown) {
    if (shown)
        state_->side.open = kDerivation;
    else if (derivation_shown())
        state_->side.open.reset();
}
bool Interface::derivation_shown() const { return state_->side.open == kDerivation; }
StepMarks Interface::marks() const {
    const Lecture& lecture = state_->lecture;
    StepMarks marks = lecture.player.running() ? marks_of(lecture.player.step()) : StepMarks{};
    if (derivation_shown()) marks.line = state_->derivation.current();
    if (lecture.exercises.running()) marks.line.reset();
    return marks;
}
std::optional<Highlight> Interface::highlighted() const { return state_->derivation.pointed_at(); }
void Interface::highlight(const std::optional<Highlight>& in_picture) { state_->derivation.highlight(in_picture); }

void Interface::show_error(std::string_view line) { state_->messages.show_error(line); }
void Interface::take_back(std::string_view line) {
    if (state_->messages.text() == line) state_->messages.dismiss();
}
void Interface::take_back_note(std::string_view line) { state_->messages.take_back(line); }
void Interface::show_note(std::string_view line) { state_->messages.show_note(line); }
void Interface::show_done(std::string_view line) {
    dismiss_error();
    show_note(line);
}
void Interface::dismiss_error() { state_->messages.dismiss(); }
std::string_view Interface::message() const { return state_->messages.text(); }
double Interface::redraw_after() const { return std::min(state_->wake, state_->messages.redraw_after()); }

bool Interface::show_tab(std::string_view id) {
    const bool numbers = numbers_in_tab(id);
    id = without_numbers(id);
    const auto line = line_of_tab(id);
    if (line) id = kTabs[kDerivation].name;
    const auto found = std::ranges::find(kTabs, id, &Tab::name);
    if (found == kTabs.end() && !id.empty()) return false;
    state_->side.open.reset();
    if (!id.empty()) state_->side.open = static_cast<std::size_t>(found - kTabs.begin());
    if (line) state_->derivation.step_from(*line);
    if (numbers) state_->derivation.show_numbers();
    return true;
}
bool Interface::record_tab(std::string_view id) {
    state_->look.still = state_->lecture.recorded = true;
    state_->panel_shown = state_->drawer_open = false;
    return show_tab(id);
}
bool Interface::typing_formula() const { return state_->panel.formula.typing(); }
Unfolded& Interface::unfolded() { return state_->unfolded; }
const Unfolded& Interface::unfolded() const { return state_->unfolded; }
std::vector<std::string>& Interface::recent_files() { return state_->dialog.recent_files(); }
const std::vector<std::string>& Interface::recent_files() const { return state_->dialog.recent_files(); }
void Interface::play(Scene& scene) { toggle(state_->stack.player, scene); }
void Interface::finish_playing(Scene& scene) { finish(state_->stack.player, scene); }
bool Interface::playing() const { return state_->stack.player.playing || state_->lecture.moving(); }

Lecture& Interface::lecture() { return state_->lecture; }
const Lecture& Interface::lecture() const { return state_->lecture; }

void Interface::open_lesson(std::shared_ptr<const Lesson> lesson, const Scene& scene, std::optional<std::size_t> step) {
    state_->side.open.reset();  // the lesson opens what it wants
    state_->lecture.start(std::move(lesson), scene, step);
}
void Interface::record_lesson(const std::shared_ptr<const Lesson>& lesson, const Scene& scene, std::size_t step,
                              std::optional<std::size_t> answer) {
    state_->look.still = state_->lecture.recorded = state_->lecture.presenting = true;
    Lesson watched = *lesson;
    for (LessonStep& each : watched.steps) each.to_try.clear();  // nobody can, in a picture
    open_lesson(std::make_shared<const Lesson>(std::move(watched)), scene, step);
    if (answer) state_->lecture.player.choose(*answer);
    if (const auto tab = state_->lecture.wanted_tab()) show_tab(*tab);
}
bool Interface::keys_are_free() const {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantTextInput && !io.NavVisible && !ImGui::IsAnyItemActive() && !state_->asks() && !state_->menu_open;
}
bool Interface::tab_is_free() const { return !state_->edits() || !state_->editor.has_keyboard(); }

void Interface::edit_formula(Scene& scene) {
    if (!std::holds_alternative<FormulaSurface>(scene.surface)) scene.surface = state_->panel.formula.last;
    state_->panel.formula.focus = state_->panel_shown = state_->drawer_open = true;
}
void Interface::toggle_help() { state_->help = !state_->help; }
void Interface::toggle_panel() {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    bool& shown = state_->panel_wanted(glm::ivec2(screen.x, screen.y));
    shown = !shown;
}
bool Interface::panel_shown() const {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    return state_->panel_wanted(glm::ivec2(screen.x, screen.y));
}
void Interface::ask_open() { state_->dialog.open(FileDialog::For::OpenAny); }
bool Interface::asks_for_file() const { return state_->dialog.is_open() && state_->dialog.opens(); }
void Interface::ask_no_more() { state_->dialog.withdraw(); }
void Interface::ask_save_scene() { state_->dialog.open(FileDialog::For::SaveScene); }
void Interface::ask_save_lesson(const std::filesystem::path& folder) {
    state_->dialog.open(FileDialog::For::SaveLesson, folder);
}
void Interface::ask_save_picture() { state_->dialog.open(FileDialog::For::SavePicture); }
void Interface::ask(Asked what, std::string title, std::string text, std::vector<std::string> choices) {
    state_->question.ask(what, std::move(title), std::move(text), std::move(choices));
}
bool Interface::dialog_shown() const { return state_->asks(); }

}  // namespace normalscope

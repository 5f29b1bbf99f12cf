#include "ui/interface.h"

#include "core/error.h"
#include "ui/file_dialog.h"
#include "ui/help.h"
#include "ui/messages.h"
#include "ui/panel.h"
#include "ui/words.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

struct Interface::State {
    Look look;
    ExtraLetters letters;
    PanelMemory panel;
    FileDialog dialog;
    Messages messages;
    bool panel_shown = true, help = false;
    double wake = std::numeric_limits<double>::infinity();
    double pointer_rested = 0.0;  ///< since when, by ImGui::GetTime
    double popups_changed = -1e9;
    bool popup = false;

    void watch_the_clock();
};

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

// The window draws only when something happens, but a tooltip comes some time after the pointer has come to rest, and
// the ground of a dialog darkens step by step.
void Interface::State::watch_the_clock() {
    const ImGuiIO& io = ImGui::GetIO();
    const double now = ImGui::GetTime();
    if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f) pointer_rested = now;
    const bool any_popup = dialog.is_open();
    if (any_popup != popup) popups_changed = now;
    popup = any_popup;

    wake = messages.redraw_after();
    const double tooltips = ImGui::GetStyle().HoverDelayNormal + ImGui::GetStyle().HoverStationaryDelay + 0.1;
    if (ImGui::IsAnyItemHovered() && now - pointer_rested < tooltips) wake = std::min(wake, 0.1);
    if (now - popups_changed < 0.3) wake = std::min(wake, 1.0 / 30.0);
    if (letters.pending()) wake = 0.0;
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
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_NavNoCaptureKeyboard;
        io.ConfigInputTextCursorBlink = false;  // a blinking cursor would redraw an idle window
        io.IniFilename = io.LogFilename = nullptr;
    }
    if (scaled || theme != look.theme) set_style(look, theme, scale);
    if (!scaled && !state_->letters.pending()) return false;
    look.fonts = build_fonts(scale, state_->letters);
    return true;
}

PixelRect Interface::picture(glm::ivec2 framebuffer) const {
    const int panel = state_->panel_shown ? static_cast<int>(state_->look.px(kPanelWidth)) : 0;
    // In a window hardly wider than the panel, the panel covers part of the picture rather than all of it.
    const int left = framebuffer.x - panel >= panel / 4 ? panel : 0;
    return {{left, 0}, {std::max(framebuffer.x - left, 1), std::max(framebuffer.y, 1)}};
}

Requests Interface::draw(Scene& scene, const Frame& frame, const Status& status) {
    Requests requests;
    State& s = *state_;
    std::vector<StackEntry> before = scene.stack;
    draw_words(frame);
    if (s.panel_shown)
        draw_panel(scene, s.panel,
                   {.look = s.look,
                    .frame = frame,
                    .status = status,
                    .requests = requests,
                    .dialog = s.dialog,
                    .help = s.help});
    const bool help = s.help;
    draw_help(s.look, frame.rect, s.help);
    s.dialog.draw(s.look, s.letters, requests);
    if (!help && !s.dialog.is_open() && !ImGui::IsAnyItemActive() && ImGui::IsKeyPressed(ImGuiKey_Escape, false))
        s.messages.dismiss();
    if (scene.stack != before) undo_overflow(scene, before, s.messages);
    s.letters.want(s.messages.text(), s.look.fonts.body);
    s.letters.want(status.file, s.look.fonts.body);
    s.messages.draw(s.look, frame);
    s.watch_the_clock();
    return requests;
}

void Interface::draw_words(const Frame& frame) const { normalscope::draw_words(state_->look, frame); }

void Interface::show_error(std::string_view line) { state_->messages.show_error(line); }
void Interface::show_note(std::string_view line) { state_->messages.show_note(line); }
double Interface::redraw_after() const { return std::min(state_->wake, state_->messages.redraw_after()); }

void Interface::toggle_help() { state_->help = !state_->help; }
void Interface::toggle_panel() { state_->panel_shown = !state_->panel_shown; }
bool Interface::panel_shown() const { return state_->panel_shown; }
void Interface::ask_open(const Scene&) { state_->dialog.open(FileDialog::For::OpenAny); }
void Interface::ask_save_scene() { state_->dialog.open(FileDialog::For::SaveScene); }
void Interface::ask_save_picture() { state_->dialog.open(FileDialog::For::SavePicture); }
bool Interface::dialog_shown() const { return state_->dialog.is_open(); }

}  // namespace normalscope

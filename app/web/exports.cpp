// What the page calls: its scripts know no more of the program than this.

#include "core/base/error.h"
#include "core/explain/numbers_json.h"
#include "core/lessons/open.h"
#include "core/lessons/scene_caption.h"
#include "core/lessons/unsaved_work.h"
#include "core/scene/scene_json.h"
#include "gl/version.h"
#include "web/keys.h"
#include "web/page.h"

#include <emscripten/em_macros.h>
#include <malloc.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

namespace normalscope {

namespace {

// The one object that the page's functions are about; the page makes it by page_start().
std::unique_ptr<Page>& the_page() {
    static std::unique_ptr<Page> page;
    return page;
}

// What the page was given last as a text: it copies it at once.
const char* given(std::string text) {
    static std::string last;
    last = std::move(text);
    return last.c_str();
}

// What is thrown has nobody above it but the browser: it becomes the viewer's own line.
template <class Work>
void with_viewer(Work&& work) {
    if (!the_page()) return;
    Viewer& viewer = the_page()->viewer();
    try {
        work(viewer);
    } catch (const std::bad_alloc&) {
        viewer.complain(kOutOfMemory);
    } catch (const std::exception& e) {
        viewer.complain(e.what());
    }
}

/// The room's light; a link says in which it was seen, which holds unless the page is `asked` for this one.
struct Light {
    bool dark, asked;
};

Opened first_of(const std::string& name, Light light, std::string& complaint) {
    Opened first{.file = std::string(kDefaultScene), .scene = load_scene(std::string(kDefaultScene))};
    first.scene.theme = light.dark ? Theme::Dark : Theme::Light;
    if (name.empty()) return first;
    try {
        Opened opened = read_file(name, first.scene);
        const bool link = opened.file.empty();
        if (light.asked || !link) opened.scene.theme = first.scene.theme;
        prepare(opened);
        return opened;
    } catch (const std::exception& e) {
        complaint = e.what();
        return first;
    }
}

std::string told(const Viewer& viewer) {
    nlohmann::ordered_json json{{"name", viewer.address()}};
    const Lecture& lecture = viewer.interface().lecture();
    if (lecture.player.running()) {
        const LessonPlayer& player = lecture.player;
        json["lesson"] = player.lesson().name;
        json["step"] = player.number() + 1;
        json["steps"] = player.lesson().steps.size();
        json["caption"] = player.step().caption;
        if (player.step().question && player.answer() && !player.revealed()) {
            json["answer"] = *player.answer() + 1;
            json["right"] = player.step().question->choices[*player.answer()].right;
        }
    }
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Remembered remembered(const char* settings, const char* unsaved, bool still) {
    Remembered result = remembered_of(settings);
    if (still) result.motion = false;
    try {
        if (*unsaved) result.unsaved = parse_unsaved(unsaved, "unsaved");
    } catch (const Error&) {  // a damaged one is of no use to anyone
    }
    return result;
}

}  // namespace

}  // namespace normalscope

using namespace normalscope;

extern "C" {

/// Opens what the address names, or the default scene. Empty, or why there is no program here.
EMSCRIPTEN_KEEPALIVE const char* page_start(const char* name, const char* settings, const char* unsaved, int width,
                                            int height, double scale, int dark, int asked_light, int still) {
    try {
        std::string complaint;
        Opened first = first_of(name, {dark != 0, asked_light != 0}, complaint);
        prepare(first);
        the_page() = std::make_unique<Page>(glm::ivec2(width, height), static_cast<float>(scale), std::move(first),
                                            remembered(settings, unsaved, still != 0));
        if (!complaint.empty()) the_page()->viewer().complain(complaint);
        return "";
    } catch (const std::exception& e) {
        return given(e.what());
    }
}

EMSCRIPTEN_KEEPALIVE void page_resize(int width, int height, double scale) {
    if (the_page()) the_page()->resize({width, height}, static_cast<float>(scale));
}
/// Draws what is to be drawn. Seconds until there is something to do again; negative: not before something happens.
EMSCRIPTEN_KEEPALIVE double page_step() {
    double due = -1.0;
    with_viewer([&](Viewer& viewer) {
        viewer.step();
        due = viewer.due();
    });
    return std::isfinite(due) ? due : -1.0;
}
/// Stores what the next visit starts with, if it has changed. For when nothing is under way.
EMSCRIPTEN_KEEPALIVE void page_remember_settings() {
    if (the_page()) the_page()->remember();
}

EMSCRIPTEN_KEEPALIVE void page_pointer(double x, double y) {
    with_viewer([&](Viewer& viewer) { viewer.pointer_to({x, y}); });
}
EMSCRIPTEN_KEEPALIVE void page_pointer_left() {
    with_viewer([](Viewer& viewer) { viewer.pointer_left(); });
}
EMSCRIPTEN_KEEPALIVE void page_button(int button, int down, int modifiers) {
    with_viewer([&](Viewer& viewer) {
        down ? viewer.press(button, modifiers_of(modifiers)) : viewer.release(button, modifiers_of(modifiers));
    });
}
EMSCRIPTEN_KEEPALIVE void page_scroll(double x, double y) {
    with_viewer([&](Viewer& viewer) { viewer.scroll({x, y}); });
}
/// Of a finger, as Viewer has them.
EMSCRIPTEN_KEEPALIVE int page_grab_to_scroll() {
    bool grabbed = false;
    with_viewer([&](Viewer& viewer) { grabbed = viewer.grab_to_scroll(); });
    return grabbed;
}
EMSCRIPTEN_KEEPALIVE void page_scroll_grabbed(double pixels) {
    with_viewer([&](Viewer& viewer) { viewer.scroll_grabbed(pixels); });
}
EMSCRIPTEN_KEEPALIVE int page_holds_what_follows() { return the_page() && the_page()->viewer().holds_what_follows(); }
EMSCRIPTEN_KEEPALIVE void page_key(const char* key, const char* code, int modifiers, int down, int repeated) {
    with_viewer([&](Viewer& viewer) {
        const ImGuiKeyChord held = modifiers_of(modifiers);
        const KeyPress press{key_of(key, code, held), held, repeated != 0};
        down ? viewer.press(press) : viewer.release(press);
    });
}
EMSCRIPTEN_KEEPALIVE void page_type(int letter) {
    with_viewer([&](Viewer& viewer) { viewer.type(static_cast<char32_t>(letter)); });
}
EMSCRIPTEN_KEEPALIVE void page_focus(int focused) {
    with_viewer([&](Viewer& viewer) { viewer.focus(focused != 0); });
}
EMSCRIPTEN_KEEPALIVE void page_open(const char* name) {
    with_viewer([&](Viewer& viewer) { viewer.open(name); });
}
/// A mesh of what the name opens that is not among the page's files. Empty: none is missing, or nothing opens.
EMSCRIPTEN_KEEPALIVE const char* page_missing(const char* name) {
    std::string missing;
    try {
        for (const std::string& file : meshes_of(read_file(name, {})))
            if (!std::filesystem::exists(file)) missing = file;
    } catch (const std::exception&) {  // whoever opens it is told
    }
    return given(std::move(missing));
}
EMSCRIPTEN_KEEPALIVE void page_complain(const char* line) {
    with_viewer([&](Viewer& viewer) { viewer.complain(line); });
}
EMSCRIPTEN_KEEPALIVE void page_pasted(const char* text) {
    if (the_page()) the_page()->set_pasted(text);
}
EMSCRIPTEN_KEEPALIVE void page_lose() {
    if (the_page()) the_page()->lose();
}
EMSCRIPTEN_KEEPALIVE void page_restore() {
    if (the_page()) with_viewer([](Viewer&) { the_page()->restore(); });
}

/// A field waits for letters.
EMSCRIPTEN_KEEPALIVE int page_wants_letters() { return the_page() && ImGui::GetIO().WantTextInput; }
/// The pointer is on a control, not on the picture.
EMSCRIPTEN_KEEPALIVE int page_on_control() { return the_page() && ImGui::GetIO().WantCaptureMouse; }
/// Something is held or moves.
EMSCRIPTEN_KEEPALIVE int page_is_busy() {
    return the_page() && (ImGui::IsAnyItemActive() || the_page()->viewer().interface().playing());
}
EMSCRIPTEN_KEEPALIVE const char* page_shown() {
    std::string address;
    with_viewer([&](const Viewer& viewer) { address = viewer.address(); });
    return given(std::move(address));
}
/// For whoever does not see the picture.
EMSCRIPTEN_KEEPALIVE const char* page_description() {
    std::string text;
    with_viewer([&](const Viewer& viewer) { text = viewer.description(); });
    return given(std::move(text));
}
EMSCRIPTEN_KEEPALIVE void page_save_picture() {
    with_viewer([](Viewer& viewer) { viewer.save_picture("/picture.png"); });
}
/// The line that is shown; empty: none.
EMSCRIPTEN_KEEPALIVE const char* page_line() {
    std::string text;
    with_viewer([&](const Viewer& viewer) { text = viewer.interface().message(); });
    return given(std::move(text));
}
/// A question waits for its answer.
EMSCRIPTEN_KEEPALIVE int page_asks() { return the_page() && the_page()->viewer().interface().dialog_shown(); }
EMSCRIPTEN_KEEPALIVE void page_move(int moves) {
    with_viewer([&](Viewer& viewer) { viewer.set_motion(moves != 0); });
}
/// How the page is set into another: without the panel, or as for a room.
EMSCRIPTEN_KEEPALIVE void page_set_in(int panel, int presenting) {
    with_viewer([&](Viewer& viewer) {
        viewer.show_panel(panel != 0);
        if (presenting) viewer.present_in_place();
    });
}
/// What a page around this one is told, as JSON: docs/web.md.
EMSCRIPTEN_KEEPALIVE const char* page_told() {
    std::string text;
    with_viewer([&](const Viewer& viewer) { text = told(viewer); });
    return given(std::move(text));
}
/// The scene, as a file has it.
EMSCRIPTEN_KEEPALIVE const char* page_scene() {
    std::string text;
    with_viewer([&](const Viewer& viewer) { text = scene_text(viewer.scene()); });
    return given(std::move(text));
}
/// Bytes in use, for the benchmark.
EMSCRIPTEN_KEEPALIVE double page_heap() { return static_cast<double>(mallinfo().uordblks); }
/// As --numbers writes it.
EMSCRIPTEN_KEEPALIVE const char* page_numbers() {
    std::string text;
    with_viewer([&](const Viewer& viewer) {
        if (viewer.frame())
            text = numbers_text(viewer.scene(), *viewer.frame(), {"page", renderer_name(), gl_version(), "webgl"});
    });
    return given(std::move(text));
}

}  // extern "C"

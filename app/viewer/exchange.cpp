#include "core/base/error.h"
#include "core/base/file.h"
#include "core/explain/explanation.h"
#include "core/image/png.h"
#include "core/lessons/link.h"
#include "core/lessons/open.h"
#include "core/mesh/mesh_file.h"
#include "core/picture/make_frame.h"
#include "core/picture/svg.h"
#include "core/scene/scene_json.h"
#include "viewer/copied_command.h"
#include "viewer/viewer.h"

#include <chrono>
#include <utility>

namespace normalscope {

namespace {

using namespace std::chrono_literals;

// A link is as long as its scene, and says nothing to people.
std::string short_name(const std::string& file) {
    return is_link(file) ? "link" : std::filesystem::path(file).filename().string();
}

// A relative path means something only where the program was started.
Scene portable(Scene scene) {
    if (auto* surface = std::get_if<MeshSurface>(&scene.surface))
        surface->mesh = std::filesystem::absolute(surface->mesh).string();
    return scene;
}

}  // namespace

void Viewer::show_title() {
    const std::string& file = document_.file();
    std::string title =
        (unsaved() ? "\u2022 " : "") + (file.empty() ? "" : short_name(file) + " \u2013 ") + "Normalscope";
    if (title != title_) host_.set_title(title_ = std::move(title));
}

void Viewer::close() {
    wake();
    if (exercising()) {
        lecture().leave(document_.scene);  // what there was before may not be saved
        document_.set_origin(origin_before_exercises_);
    }
    if (!unsaved()) {
        host_.keep("");
        return host_.close();
    }
    gui_.interface.ask(Asked::Closing, "Save the scene?",
                       "It has been changed since it was " + std::string(document_.has_file() ? "saved." : "opened."),
                       {"Save", "Discard", "Stay"});
}

void Viewer::offer(Scene unsaved) {
    offered_ = std::move(unsaved);
    gui_.interface.ask(Asked::Recovering, "Go back to the scene of last time?",
                       "The program ended before it was saved.", {"Go back", "No"});
}

void Viewer::obey(const Reply& reply) {
    if (reply.asked == Asked::Recovering) {
        if (reply.choice == 0 && offered_) document_.recover(std::move(*offered_));
        offered_.reset();
        return;
    }
    if (reply.choice == 2) return;
    closes_when_saved_ = reply.choice == 0;
    if (closes_when_saved_) return save();
    host_.keep("");
    host_.close();
}

void Viewer::keep_unsaved() {
    if (exercising()) return;  // what there was before is kept
    const auto unheld = unsaved() ? std::optional(document_.scene) : std::nullopt;
    if (unheld == kept_) return;
    host_.keep(unheld ? scene_text(portable(*unheld)) : "");
    kept_ = unheld;
}

void Viewer::save() {
    if (!document_.has_file()) return gui_.interface.ask_save_scene();
    try {
        save_scene(document_.file());
    } catch (const Error& e) {
        gui_.interface.show_error(e.what());
    }
}

void Viewer::open(const std::string& name) {
    wake();
    if (opening_) return gui_.interface.show_note("Still reading a file");
    // In another thread: the window stays alive while a large mesh is read.
    opening_ =
        beside([name, scene = lecture().exercises.scene_before(document_.scene)] { return open_file(name, scene); });
    if (!opening_.ready(150ms)) gui_.interface.show_note("Reading " + short_name(name) + " \u2026");
}

void Viewer::finish_opening() {
    if (!opening_ || !opening_.ready()) return;
    wake();
    try {
        take(opening_.get());
    } catch (const Error& e) {
        gui_.interface.show_error(e.what());
    }
}

void Viewer::take(Opened opened) {
    commit();
    if (opened.exercises) {
        if (!exercising()) origin_before_exercises_ = document_.origin();
        document_.set_origin(std::make_shared<Origin>(Origin{.file = opened.file, .saved = {}}));
        lecture().start_exercises(*opened.exercises, document_.scene);
    } else if (opened.lesson) {
        surfaces_ = std::move(opened.surfaces);
        document_.open_lesson(opened.lesson->name);
        gui_.interface.open_lesson(std::move(opened.lesson), document_.scene, opened.step);
    } else {
        lecture().exercises.stop();
        const bool goes_on = is_mesh_file(opened.file) && document_.unsaved();  // a mesh changes the surface alone
        const Scene saved = document_.origin()->saved;
        opened.scene.theme = document_.scene.theme;  // the room's light does not change with the scene
        surfaces_ = std::move(opened.surfaces);
        document_.open(std::move(opened.scene), opened.file);
        if (goes_on) document_.origin()->saved = saved;
    }
}

void Viewer::save_scene(const std::filesystem::path& file) {
    normalscope::save_scene(document_.scene, file);
    document_.saved_as(file.string());
    gui_.interface.show_note("Saved " + document_.file());
    if (std::exchange(closes_when_saved_, false)) close();
}

void Viewer::save_picture(const std::filesystem::path& file) {
    if (file.extension() == ".svg") {
        const PixelRect rect{{0, 0}, gui_.interface.picture(host_.framebuffer_size()).size};
        const Frame vectors = make_frame(shown_scene(), surfaces_->get(document_.scene),
                                         {.rect = rect, .pixel_scale = scale(), .handles = false});
        write_file(file, svg_text(shown_scene(), vectors, scale(), Ground::Scene));
        return gui_.interface.show_note("Saved " + file.string());
    }
    const Frame frame = frame_now(Marks::AsSaved);
    gui_.layout(shown_scene().theme, scale(), [&] { gui_.interface.draw_words(frame); });
    drawn_.reset();
    write_png(file, cropped(host_.image_of(frame), frame.rect.origin, frame.rect.size));
    gui_.interface.show_note("Saved " + file.string());
    wake();
}

void Viewer::copy_command() {
    const glm::ivec2 size = gui_.interface.picture(host_.framebuffer_size()).size;
    host_.set_clipboard(capture_command(document_.scene, document_.file(), size, host_.content_scale()));
    gui_.interface.show_note("Copied the command that draws this picture");
}

void Viewer::copy_link() {
    host_.set_clipboard(link_of(document_.scene));
    const auto* mesh = std::get_if<MeshSurface>(&document_.scene.surface);
    gui_.interface.show_note(mesh ? "Copied a link to this scene. It names " + mesh->mesh +
                                        " but does not hold it: whoever opens the link needs that file there"
                                  : "Copied a link to this scene: paste it with Ctrl+V, or give it as FILE");
}

void Viewer::copy_equations() {
    const auto probe = frame_ && frame_->probe ? std::optional(frame_->probe->object) : std::nullopt;
    host_.set_clipboard(equations_latex(explanation(document_.scene, probe)));
    gui_.interface.show_note("Copied the equations as LaTeX (packages amsmath and color)");
}

void Viewer::paste() {
    const std::string text = host_.clipboard();
    if (!is_link(text)) return gui_.interface.show_note("The clipboard holds no link; one begins with normalscope:");
    open(text);
}

}  // namespace normalscope

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/explain/explanation.h"
#include "core/image/png.h"
#include "core/lessons/link.h"
#include "core/lessons/open_scene.h"
#include "core/picture/make_frame.h"
#include "core/picture/svg.h"
#include "core/scene/scene_json.h"
#include "viewer/copied_command.h"
#include "viewer/viewer.h"

#include <chrono>

namespace normalscope {

namespace {

using namespace std::chrono_literals;

// A link is as long as its scene, and says nothing to people.
std::string short_name(const std::string& file) {
    return is_link(file) ? "link" : std::filesystem::path(file).filename().string();
}

}  // namespace

void Viewer::set_title() { host_.set_title((file_.empty() ? "" : short_name(file_) + " \u2013 ") + "Normalscope"); }

void Viewer::open(const std::string& name) {
    wake();
    if (opening_.valid()) return gui_.interface.show_note("Still reading a file");
    // In another thread: the window stays alive while a large mesh is read.
    opening_ = std::async(std::launch::async,
                          [name, scene = lecture().predict.scene_before(scene_)] { return open_file(name, scene); });
    if (opening_.wait_for(150ms) != std::future_status::ready)
        gui_.interface.show_note("Reading " + short_name(name) + " \u2026");
}

void Viewer::finish_opening() {
    if (!opening_.valid() || opening_.wait_for(0s) != std::future_status::ready) return;
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
        if (!exercising()) file_before_exercises_ = file_;
        file_ = opened.file;
        lecture().start_exercises(*opened.exercises, scene_);
    } else if (opened.lesson) {
        surfaces_ = std::move(opened.surfaces);
        file_ = opened.lesson->name;
        gui_.interface.open_lesson(std::move(opened.lesson), scene_, opened.step);
    } else {
        lecture().predict.stop();
        opened.scene.theme = scene_.theme;  // the room's light does not change with the scene
        scene_ = std::move(opened.scene);
        surfaces_ = std::move(opened.surfaces);
        file_ = is_link(opened.file) ? "" : std::move(opened.file);
    }
    set_title();
}

void Viewer::save_scene(const std::filesystem::path& file) {
    normalscope::save_scene(scene_, file);
    file_ = file.string();
    set_title();
    gui_.interface.show_note("Saved " + file_);
}

void Viewer::save_picture(const std::filesystem::path& file) {
    if (file.extension() == ".svg") {
        const PixelRect rect{{0, 0}, gui_.interface.picture(host_.framebuffer_size()).size};
        const Frame vectors =
            make_frame(shown_scene(), surfaces_->get(scene_), {.rect = rect, .pixel_scale = scale(), .handles = false});
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
    host_.set_clipboard(capture_command(scene_, file_, size, host_.content_scale()));
    gui_.interface.show_note("Copied the command that draws this picture");
}

void Viewer::copy_link() {
    host_.set_clipboard(link_of(scene_));
    const auto* mesh = std::get_if<MeshSurface>(&scene_.surface);
    gui_.interface.show_note(mesh ? "Copied a link to this scene. It names " + mesh->mesh +
                                        " but does not hold it: whoever opens the link needs that file there"
                                  : "Copied a link to this scene: paste it with Ctrl+V, or give it as FILE");
}

void Viewer::copy_equations() {
    const auto probe = frame_ && frame_->probe ? std::optional(frame_->probe->object) : std::nullopt;
    host_.set_clipboard(equations_latex(explanation(scene_, probe)));
    gui_.interface.show_note("Copied the equations as LaTeX (packages amsmath and color)");
}

void Viewer::paste() {
    const std::string text = host_.clipboard();
    if (!is_link(text)) return gui_.interface.show_note("The clipboard holds no link; one begins with normalscope:");
    open(text);
}

}  // namespace normalscope

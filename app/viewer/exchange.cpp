#include "core/base/decimal.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/system.h"
#include "core/base/text.h"
#include "core/explain/explanation.h"
#include "core/image/png.h"
#include "core/lessons/address.h"
#include "core/lessons/link.h"
#include "core/lessons/open.h"
#include "core/lessons/scene_caption.h"
#include "core/mesh/mesh_file.h"
#include "core/picture/make_frame.h"
#include "core/picture/svg.h"
#include "core/scene/scene_json.h"
#include "viewer/copied_command.h"
#include "viewer/viewer.h"

#include <algorithm>
#include <chrono>
#include <ranges>
#include <utility>

namespace normalscope {

namespace {

using namespace std::chrono_literals;

// A link is as long as its scene, and says nothing to people.
std::string short_name(const std::string& file) {
    return is_link(file) ? "link" : std::filesystem::path(file).filename().string();
}

std::string name_of(const Work& work) {
    return work.origin->file.empty() ? "a scene without a name" : short_name(work.origin->file);
}

}  // namespace

void Viewer::show_title() {
    const std::string& file = document_.file();
    std::string title =
        (document_.unsaved() ? "\u2022 " : "") + (file.empty() ? "" : short_name(file) + " \u2013 ") + "Normalscope";
    if (title != title_) host_.set_title(title_ = std::move(title));
}

// What there was before may not be saved.
void Viewer::leave_exercises() {
    if (!exercising()) return;
    lecture().leave(document_.scene);
    document_.set_origin(origin_before_exercises_);
}

void Viewer::close() {
    wake();
    leave_exercises();
    const std::vector<Work> all = document_.all_unsaved();
    std::vector<Work> works = all;
    std::erase_if(works, [&](const Work& work) { return !can_be_drawn(work.scene); });
    if (!works.empty()) return ask_to_save(works);
    keep(all);  // what can be shown to nobody may be shown next time
    host_.close();
}

void Viewer::ask_to_save(const std::vector<Work>& works) {
    document_.go_back_to(works.back());  // what is asked about is seen
    follow_draft();
    std::string text = "It has been changed since it was " + std::string(document_.has_file() ? "saved" : "opened");
    std::string others;
    for (const Work& work : works | std::views::reverse | std::views::drop(1))
        others += (others.empty() ? "" : ", ") + name_of(work);
    text += others.empty() ? "." : ". So have others that were open: " + others + ".";
    const bool lesson = document_.draft.lesson != nullptr;
    gui_.interface.ask(Asked::Closing, lesson ? "Save the lesson?" : "Save the scene?", std::move(text),
                       {"Save", others.empty() ? "Discard" : "Discard all", "Stay"});
}

void Viewer::go_on_with_what_is_shown() {
    if (!document_.file().empty() || in_lesson() || exercising()) return;
    const auto as_linked = [&](const UnsavedWork& work) {
        Scene scene = work.scene;
        scene.theme = document_.scene.theme;                     // the room's light
        if (document_.scene.about.empty()) scene.about.clear();  // a link leaves out what is so no more
        return !work.draft.lesson && scene == document_.scene;
    };
    const auto found = std::ranges::find_if(offered_, as_linked);
    if (found == offered_.end()) return;
    UnsavedWork work = std::move(*found);
    offered_.erase(found);
    work.scene.theme = document_.scene.theme;
    document_.recover(work);
}

void Viewer::offer() {
    unanswered_ = true;
    keep({});
    const std::string which = offered_.size() > 1 ? "scenes" : offered_.front().draft.lesson ? "lesson" : "scene";
    gui_.interface.ask(Asked::Recovering, "Go back to the " + which + " of last time?",
                       offered_.size() > 1
                           ? "The program ended before they were saved. Ctrl+Z goes from one to the next."
                           : "The program ended before it was saved.",
                       {"Go back", "Discard", "Not now"});
}

void Viewer::obey(const Reply& reply) {
    if (reply.asked == Asked::Recovering) {
        unanswered_ = false;
        if (reply.choice == 2) return;  // kept until the next start
        const std::vector<UnsavedWork> offered = std::exchange(offered_, {});
        if (reply.choice == 1) return;
        leave_exercises();  // in their scene there would be no work
        for (const UnsavedWork& work : offered)
            if (can_be_drawn(work.scene))
                document_.recover(work), follow_draft();
            else
                offered_.push_back(work);  // perhaps next time
        return;
    }
    if (reply.choice == 2) {
        if (unanswered_) offer();  // this is still to be answered
        return;
    }
    closes_when_saved_ = reply.choice == 0;
    if (closes_when_saved_) return save();
    document_.discard();
    close();
}

void Viewer::keep(const std::vector<Work>& works) {
    keep_due_.reset();
    std::vector<UnsavedWork> all = offered_;
    for (const Work& work : works)
        all.push_back({work.origin->file, work.draft.lesson ? work.scene : given(work), work.draft});
    if (all == kept_) return;
    host_.keep(all.empty() ? "" : unsaved_text(all));
    kept_ = std::move(all);
}

void Viewer::ask_save() { document_.draft.lesson ? ask_save_lesson() : gui_.interface.ask_save_scene(); }

void Viewer::save() {
    std::error_code error;
    const bool lesson = document_.draft.lesson != nullptr;
    if (lesson ? !std::filesystem::is_regular_file(document_.file(), error) : !document_.has_file()) return ask_save();
    try {
        lesson ? save_lesson(document_.file()) : save_scene(document_.file());
    } catch (const Error& e) {
        gui_.interface.show_error(e.what());
    }
}

void Viewer::show_panel(bool shown) {
    wake();
    if (gui_.interface.panel_shown() != shown) gui_.interface.toggle_panel();
}

void Viewer::present_in_place() {
    wake();
    lecture().present(true);
}

void Viewer::complain(std::string_view line) {
    wake();
    gui_.interface.show_error(line);
}

std::string Viewer::description() const {
    const Scene& now = document_.scene;
    std::string text = (in_lesson() ? lecture().player.step().caption : said_of(now).caption) + " Normals follow the " +
                       std::string(name(now.rule)) + " rule.";
    if (frame_ && frame_->probe && frame_->probe->error_degrees)
        text += " At the probe, the naive normal is " + with_decimals(*frame_->probe->error_degrees, 3) +
                " degrees from perpendicular.";
    return text;
}

std::string Viewer::address() const {
    if (exercising()) return "exercises:" + std::to_string(lecture().exercises.seed());
    if (in_lesson() && is_built_in_lesson(document_.file()))
        return address_of_step(document_.file(), lecture().player.number());
    if (document_.as_opened() && is_built_in_scene(document_.file())) return document_.file();
    return link_of(document_.given());
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

void Viewer::note_file(const std::filesystem::path& file) {
    constexpr std::size_t kMost = 12;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return;  // what is built in, or a link
    const std::string whole = text_of(std::filesystem::absolute(file, error).lexically_normal());
    std::vector<std::string>& files = gui_.interface.recent_files();
    std::erase(files, whole);
    files.insert(files.begin(), whole);
    if (files.size() > kMost) files.pop_back();
}

void Viewer::take(Opened opened) {
    gui_.interface.dismiss_error();  // of an earlier try, which would cover this
    commit();
    note_file(opened.lesson ? opened.lesson->name : opened.file);
    const std::shared_ptr<Origin> left = document_.origin();
    if (opened.exercises) {
        if (in_lesson()) {
            lecture().player.arrive(document_.scene);
            document_.settle();
        }
        if (!exercising()) origin_before_exercises_ = document_.origin();
        document_.play(opened.file);
        lecture().start_exercises(*opened.exercises, document_.scene);
    } else if (opened.lesson) {
        surfaces_.take(std::move(opened.surfaces));
        document_.play(opened.lesson->name);
        gui_.interface.open_lesson(std::move(opened.lesson), document_.scene, opened.step);
    } else {
        lecture().exercises.stop();
        opened.scene.theme = document_.scene.theme;  // the room's light does not change with the scene
        surfaces_.take(std::move(opened.surfaces));
        if (document_.draft.lesson)
            document_.scene = std::move(opened.scene);  // a view for the lesson that is being written
        else if (is_mesh_file(opened.file))
            document_.open_mesh(std::move(opened.scene), opened.file);
        else
            document_.open(std::move(opened.scene), opened.file);
        wants_room_ = is_mesh_file(opened.file);  // a scene says itself from where it is seen
    }
    // A picture by itself, as in another page, says nothing but what it shows.
    if (presenting() || !gui_.interface.panel_shown() || left == document_.origin()) return;
    for (const Work& work : document_.all_unsaved())
        if (work.origin == left)
            gui_.interface.show_note("Ctrl+Z goes back to " + name_of(work) + ", which is not saved");
}

void Viewer::save_scene(const std::filesystem::path& file) {
    document_.scene = document_.given();
    normalscope::save_scene(document_.scene, file);
    document_.saved_as(file.string());
    note_file(file);
    host_.saved(file);
    gui_.interface.show_done("Saved " + document_.file());
    if (std::exchange(closes_when_saved_, false)) close();
}

void Viewer::save_picture(const std::filesystem::path& file) {
    if (has_ending(file.string(), ".svg")) {
        const PixelRect rect{{0, 0}, gui_.interface.picture(host_.framebuffer_size()).size};
        const Frame vectors = make_frame(shown_scene(), surfaces_.get_now(document_.scene),
                                         {.rect = rect, .pixel_scale = scale(), .handles = false});
        write_file(file, svg_text(shown_scene(), vectors, scale(), Ground::Scene));
        host_.saved(file);
        return gui_.interface.show_done("Saved " + file.string());
    }
    const Frame frame = frame_now(Marks::AsSaved);
    gui_.layout(shown_scene().theme, scale(), [&] { gui_.interface.draw_words(frame); });
    drawn_.reset();
    write_png(file, cropped(host_.image_of(frame), frame.rect.origin, frame.rect.size));
    host_.saved(file);
    gui_.interface.show_done("Saved " + file.string());
    wake();
}

void Viewer::copy_command() {
    const glm::ivec2 size = gui_.interface.picture(host_.framebuffer_size()).size;
    host_.set_clipboard(capture_command(document_.scene, *document_.origin(), size, host_.content_scale()));
    gui_.interface.show_note("Copied the command that draws this picture");
}

void Viewer::copy_link() {
    host_.set_clipboard(host_.address_of(link_of(document_.given())));
    const auto* mesh = std::get_if<MeshSurface>(&document_.scene.surface);
    gui_.interface.show_note(mesh ? "Copied a link to this scene. It names " + mesh->mesh +
                                        " but does not hold it: anyone who opens the link needs that file, too"
                                  : "Copied a link to this scene: Ctrl+V opens it");
}

void Viewer::copy_frame() {
    const bool lesson = in_lesson() && is_built_in_lesson(document_.file());
    host_.set_clipboard(frame_html(host_.address_of(lesson ? address() : link_of(document_.given())),
                                   said_of(document_.scene).caption));
    gui_.interface.show_note("Copied HTML: in a page beside normalscope.html it shows this");
}

void Viewer::copy_equations() {
    const auto probe = frame_ && frame_->probe ? std::optional(frame_->probe->object) : std::nullopt;
    host_.set_clipboard(equations_latex(explanation(document_.scene, probe)));
    gui_.interface.show_note("Copied the equations as LaTeX (packages amsmath and color)");
}

void Viewer::paste() {
    const std::string text = host_.clipboard();
    const bool address = text.starts_with("http") && text.find('#') != text.npos;
    if (!is_link(text) && !address)
        return gui_.interface.show_note("There is no link on the clipboard; a link begins with normalscope:");
    open(text);
}

}  // namespace normalscope

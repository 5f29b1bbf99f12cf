#include "commands/commands.h"

#include "batch/cancel.h"
#include "batch/progress.h"
#include "commands/files_of_run.h"
#include "commands/live_handout.h"
#include "commands/step_html.h"
#include "commands/studio.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/html.h"
#include "core/base/temporary_folder.h"
#include "core/frame/display_scale.h"
#include "core/image/png.h"
#include "core/lessons/open.h"
#include "platform/crash_line.h"
#include "ui/lecture/marks_of_step.h"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

// A slide fills the window, and Page Down snaps to the next: no script is needed.
constexpr std::string_view kSlideStyle = R"(
  html { scroll-snap-type: y mandatory; scrollbar-width: none; font: 2.2vh/1.4 "Open Sans", "Segoe UI", Helvetica, Arial, sans-serif;
         color: #22262b; background: #fff; }
  body { margin: 0; }
  section { height: 100vh; scroll-snap-align: start; scroll-snap-stop: always; overflow: hidden; display: flex;
            flex-direction: column; }
  img { flex: 1; min-height: 0; width: 100%; object-fit: contain; background: #f4f5f5; }
  .words { padding: 1.6vh 4vw 2.4vh; }
  .title { margin: 0 0 .4vh; color: #69707a; font-size: 1.7vh; }
  .caption { margin: 0; font-size: 3vh; }
  .equation { margin: .8vh 0 0; font-size: 3.4vh; white-space: pre-wrap; }
  .look { margin: .6vh 0 0; color: #575d66; }
  ol.choices { list-style: upper-alpha; margin: .6vh 0 0; font-size: 2.6vh; }
  .tangent { color: #0072b2; } .naive { color: #a84a00; } .right { color: #007a59; }
)";

// Nothing of a user's is written over: a folder that is new, or holds nothing.
void make_empty_folder(const fs::path& folder) {
    std::error_code error;
    if (fs::is_directory(folder, error) && !fs::is_empty(folder, error))
        throw InputError(folder.string(), "holds something already; name a new folder, or empty this one");
    make_folder(folder);
}

std::string words(const Lesson& lesson, std::size_t i) {
    const LessonStep& step = lesson.steps[i];
    std::string html = "  <div class=\"words\">\n  <p class=\"title\">" + html_math(lesson.title) + " · " +
                       std::to_string(i + 1) + " of " + std::to_string(lesson.steps.size()) +
                       "</p>\n  <p class=\"caption\">" + html_math(step.caption) + "</p>\n";
    html += equations_html(step);
    if (step.question) html += question_html(*step.question);
    return html + "  </div>\n";
}

std::string file_name(std::size_t i) { return (i < 9 ? "0" : "") + std::to_string(i + 1) + ".png"; }

}  // namespace

int run(const SlidesCommand& command) {
    const Lesson lesson = load_lesson(command.lesson);
    FilesOfRun files;
    for (const LessonStep& step : lesson.steps) files.reads_scene(command.lesson, step.scene);
    std::optional<LiveHandout> live;
    if (command.live) live.emplace(files);
    const CancelOnSignal cancel;  // before anything is made that it would have to take away
    make_empty_folder(command.folder);
    const TemporaryFolder made(command.folder / "index.html");
    const CrashLine crash_line;
    Studio studio({.context = command.context, .pictures = lesson.steps.size()});
    std::string html = page_head(lesson.title, kSlideStyle, live ? LiveHandout::policy() : "");
    Progress progress(lesson.steps.size());
    for (std::size_t i = 0; i < lesson.steps.size() && !CancelOnSignal::asked(); ++i) {
        const LessonStep& step = lesson.steps[i];
        const CaptureOptions options{.size = command.size,
                                     .scale = 1.5f * usual_scale(command.size),
                                     .tab = step.tab,
                                     .tab_is = CaptureOptions::TabIs::Whole,
                                     .legend_corner = Frame::LegendCorner::WhereFree,
                                     .marks = marks_of(step)};
        const Image image = studio.capture(step.scene, options).image;
        write_png(made.path() / file_name(i), image);
        // A live page takes no file from beside it.
        const std::string source = live ? data_of(image) : file_name(i);
        html += "<section>\n" + picture_html(step, source, live ? live->attributes(step.scene) : "") +
                words(lesson, i) + "</section>\n";
        progress.step();
    }
    progress.hide();
    if (CancelOnSignal::asked()) {
        std::fprintf(stderr, "normalscope: cancelled; no slides were written\n");
        return CancelOnSignal::exit_code();
    }
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
        fs::rename(made.path() / file_name(i), command.folder / file_name(i));
    write_file(command.folder / "index.html", html + (live ? live->program() : "") + "</body>\n</html>\n");
    return 0;
}

}  // namespace normalscope

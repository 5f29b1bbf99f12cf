#include "commands/commands.h"

#include "commands/files_of_run.h"
#include "commands/live_handout.h"
#include "commands/step_html.h"
#include "commands/studio.h"
#include "core/base/file.h"
#include "core/base/html.h"
#include "core/frame/display_scale.h"
#include "core/lessons/open.h"
#include "platform/crash_line.h"
#include "ui/lecture/marks_of_step.h"

#include <optional>
#include <vector>

namespace normalscope {

namespace {

// On paper in two columns, with words of 9 points and more, room for notes, and page numbers where the browser has them.
constexpr std::string_view kStyle = R"(
  body { font: 17px/1.45 "Open Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #22262b; background: #fff;
         max-width: 60rem; margin: 2.5rem auto; padding: 0 1.5rem; }
  article + article { margin-top: 4rem; }
  h1 { font-size: 1.9rem; margin: 0 0 .2rem; }
  h2 { font-size: 1.2rem; margin: 0 0 .4rem; break-after: avoid; }
  .about { color: #69707a; margin: 0 0 2rem; }
  section { margin: 0 0 2.2rem; break-inside: avoid; }
  section:has(.tab) { break-inside: auto; }
  img { width: 100%; box-sizing: border-box; height: auto; display: block; border: 1px solid #dcdee0; border-radius: 6px; }
  .caption { margin: .6rem 0 0; font-weight: 600; }
  .look { margin: .3rem 0 0; color: #575d66; }
  .notes { margin: .5rem 0 0; padding: .3rem .7rem; border-left: 3px solid #dcdee0; white-space: pre-wrap; }
  .equation { margin: .5rem 0 0; font-size: 1.3rem; white-space: pre-wrap; }
  .equation i { font-style: italic; }
  .tangent { color: #0072b2; } .naive { color: #a84a00; } .right { color: #007a59; }
  ol.choices { list-style: upper-alpha; margin: .5rem 0 0; }
  .answers { border-top: 1px solid #dcdee0; padding-top: 1rem; font-size: .93rem; }
  .answer { break-inside: avoid; }
  .room { display: none; }
  @page { size: A4; margin: 13mm 13mm 15mm; @bottom-center { content: counter(page); font: 9pt sans-serif; } }
  @media print {
    body { margin: 0; padding: 0; max-width: none; font-size: 9.5pt; line-height: 1.35; }
    article + article { margin: 0; break-before: page; }
    h1 { font-size: 15pt; } .about { margin: 0 0 4mm; } h2 { font-size: 11pt; }
    .steps { columns: 2; column-gap: 8mm; }
    img { width: 92%; } img.tab { width: auto; max-width: 100%; max-height: 250mm; }
    section { margin: 0 0 5mm; } .caption { margin-top: 1.5mm; }
    .look, .answers { font-size: 9pt; } .equation { font-size: 11pt; margin-top: 1mm; }
    ol.choices { margin: 1mm 0 0; padding-left: 6mm; }
    .answers { margin-top: 3mm; padding-top: 3mm; columns: 2; column-gap: 8mm; }
    .room { display: block; height: 6mm; border-bottom: .3mm dotted #a0a5ab; }
  }
)";

// A printed picture is half a page wide, and what is written in it is to be read.
constexpr float kLargeWords = 1.8f;

std::string answer(const Question& question) {
    std::string html = "  <ol class=\"choices\">\n";
    for (const Choice& choice : question.choices)
        html +=
            std::string("    <li>") + (choice.right ? "<b>Right.</b> " : "") + html_math(choice.because) + "</li>\n";
    return html + "  </ol>\n";
}

std::string answers(const Lesson& lesson) {
    std::string html;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
        if (const auto& question = lesson.steps[i].question)
            html += "  <div class=\"answer\">\n  <p>Step " + std::to_string(i + 1) + ". " + html_math(question->text) +
                    "</p>\n" + answer(*question) + "  </div>\n";
    return html.empty() ? html : "<div class=\"answers\">\n  <h2>Answers</h2>\n" + html + "</div>\n";
}

// The lesson's own words, and the picture, which is made by the caller.
std::string words(const LessonStep& step, std::size_t number, const HandoutCommand& command) {
    std::string html = "  <p class=\"caption\">" + std::to_string(number) + ". " + html_math(step.caption) + "</p>\n";
    html += equations_html(step);
    if (step.question) html += question_html(*step.question);
    if (step.question && command.answers == HandoutCommand::Answers::Inline) html += answer(*step.question);
    if (command.notes && !step.notes.empty()) html += "  <p class=\"notes\">" + html_math(step.notes) + "</p>\n";
    return html;
}

// What the step opens beside the picture stands below its words, as wide, in letters that can be read on paper.
std::string tab_html(const LessonStep& step, Studio& studio, int picture_width) {
    constexpr int kLogicalWidth = 460;
    const Image image =
        studio
            .capture(step.scene, {.scale = std::max(static_cast<float>(picture_width) / kLogicalWidth, 1.0f),
                                  .tab = step.tab,
                                  .tab_is = CaptureOptions::TabIs::Alone,
                                  .marks = marks_of(step)})
            .image;
    return "  <img class=\"tab\" alt=\"" + html_text(step.tab) + "\" src=\"" + data_of(image) + "\">\n";
}

std::string handout(const HandoutCommand& command) {
    const std::vector<Lesson> lessons = load_lessons(command.lesson);
    FilesOfRun files;
    std::size_t pictures = 0;
    for (const Lesson& lesson : lessons) {
        pictures += lesson.steps.size();
        for (const LessonStep& step : lesson.steps) files.reads_scene(command.lesson, step.scene);
    }
    files.writes(command.output, "--output");
    std::optional<LiveHandout> live;
    if (command.live) live.emplace(files);
    const CrashLine crash_line;
    Studio studio({.context = command.context, .pictures = pictures});
    const std::string title = lessons.size() == 1 ? lessons.front().title : "Normalscope: all lessons";
    std::string html = page_head(title, kStyle, live ? LiveHandout::policy() : "");
    for (const Lesson& lesson : lessons) {
        html += "<article>\n<h1>" + html_math(lesson.title) + "</h1>\n<p class=\"about\">" + html_math(lesson.about) +
                "</p>\n<div class=\"steps\">\n";
        for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
            const LessonStep& step = lesson.steps[i];
            const Image image = studio
                                    .capture(step.scene, {.size = command.size,
                                                          .scale = kLargeWords * usual_scale(command.size),
                                                          .legend_corner = Frame::LegendCorner::WhereFree,
                                                          .marks = marks_of(step)})
                                    .image;
            html += "<section>\n" + picture_html(step, data_of(image), live ? live->attributes(step.scene) : "");
            html += words(step, i + 1, command);
            if (!step.tab.empty()) html += tab_html(step, studio, command.size.x);
            html += "</section>\n";
        }
        html += "</div>\n";
        if (command.answers == HandoutCommand::Answers::End) html += answers(lesson);
        for (int line = 0; line < 4; ++line) html += "<div class=\"room\"></div>\n";
        html += "</article>\n";
    }
    return html + (live ? live->program() : "") + "</body>\n</html>\n";
}

}  // namespace

int run(const HandoutCommand& command) {
    write(command.output, handout(command));
    return 0;
}

}  // namespace normalscope

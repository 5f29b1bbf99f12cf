#include "commands/commands.h"

#include "commands/files_of_run.h"
#include "commands/live_handout.h"
#include "commands/studio.h"
#include "core/base/base64.h"
#include "core/base/file.h"
#include "core/base/html.h"
#include "core/image/png.h"
#include "core/lessons/open.h"
#include "platform/crash_line.h"

#include <optional>

namespace normalscope {

namespace {

constexpr std::string_view kStyle = R"(
  body { font: 17px/1.45 "Open Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #22262b; background: #fff;
         max-width: 60rem; margin: 2.5rem auto; padding: 0 1.5rem; }
  h1 { font-size: 1.9rem; margin: 0 0 .2rem; }
  .about { color: #69707a; margin: 0 0 2rem; }
  section { margin: 0 0 2.2rem; break-inside: avoid; }
  img { width: 100%; height: auto; display: block; border: 1px solid #dcdee0; border-radius: 6px; }
  .caption { margin: .6rem 0 0; font-weight: 600; }
  .look { margin: .3rem 0 0; color: #575d66; }
  .equation { margin: .5rem 0 0; font-size: 1.3rem; white-space: pre-wrap; }
  .equation i { font-style: italic; }
  .tangent { color: #0072b2; } .naive { color: #a84a00; } .right { color: #007a59; }
  ol.choices { list-style: upper-alpha; margin: .5rem 0 0; }
  .answers { border-top: 1px solid #dcdee0; padding-top: 1rem; break-inside: avoid; font-size: .93rem; }
  @media print { body { margin: 0; max-width: none; font-size: 11pt; } section { margin-bottom: 1.4rem; }
                 img { max-height: 42vh; width: auto; margin: 0 auto; } }
)";

std::string picture(const LessonStep& step, const Image& image, const std::string& attributes) {
    return "  <img" + attributes + " alt=\"" + html_text(step.caption) + "\" src=\"data:image/png;base64," +
           base64(png_bytes(image)) + "\">\n";
}

std::string choices(const Question& question) {
    std::string html = "  <p class=\"caption\">" + html_math(question.text) + "</p>\n  <ol class=\"choices\">\n";
    for (const Choice& choice : question.choices) html += "    <li>" + html_math(choice.text) + "</li>\n";
    return html + "  </ol>\n";
}

std::string answers(const Lesson& lesson) {
    std::string html;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const auto& question = lesson.steps[i].question;
        if (!question) continue;
        html += "  <p>Step " + std::to_string(i + 1) + ". " + html_math(question->text) + "</p>\n";
        html += "  <ol class=\"choices\">\n";
        for (const Choice& choice : question->choices)
            html += std::string("    <li>") + (choice.right ? "<b>Right.</b> " : "") + html_math(choice.because) +
                    "</li>\n";
        html += "  </ol>\n";
    }
    return html.empty() ? html : "<div class=\"answers\">\n  <h2>Answers</h2>\n" + html + "</div>\n";
}

std::string handout(const HandoutCommand& command) {
    const Lesson lesson = load_lesson(command.lesson);
    FilesOfRun files;
    for (const LessonStep& step : lesson.steps) files.reads_scene(command.lesson, step.scene);
    files.writes(command.output, "--output");
    std::optional<LiveHandout> live;
    if (command.live) live.emplace(files);
    const CrashLine crash_line;
    Studio studio({.context = command.context, .pictures = lesson.steps.size()});
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" +
                       html_text(lesson.title) + "</title>\n<style>" + std::string(kStyle) + "</style>\n" +
                       (live ? LiveHandout::policy() : "") + "</head>\n<body>\n";
    html += "<h1>" + html_math(lesson.title) + "</h1>\n<p class=\"about\">" + html_math(lesson.about) + "</p>\n";
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        html += "<section>\n";
        html += picture(step, studio.capture(step.scene, {.size = command.size}).image,
                        live ? live->attributes(step.scene) : "");
        html += "  <p class=\"caption\">" + std::to_string(i + 1) + ". " + html_math(step.caption) + "</p>\n";
        for (const std::string& line : step.equations) html += "  <p class=\"equation\">" + html_math(line) + "</p>\n";
        if (!step.look_at.empty()) html += "  <p class=\"look\">" + html_math(step.look_at) + "</p>\n";
        if (step.question) html += choices(*step.question);
        html += "</section>\n";
    }
    return html + answers(lesson) + (live ? live->program() : "") + "</body>\n</html>\n";
}

}  // namespace

int run(const HandoutCommand& command) {
    write(command.output, handout(command));
    return 0;
}

}  // namespace normalscope

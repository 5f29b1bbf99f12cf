#include "cli/declare.h"

#include "cli/values.h"

#include <memory>
#include <string>

namespace normalscope {

namespace {

void add_lesson(CLI::App& app, std::string& value, const std::string& or_else = "") {
    add(app, "LESSON", value, "",
        "A lesson: its file (.json) or a built-in one's name (see normalscope lessons)" + or_else)
        .required();
}

}  // namespace

Declared declare_lessons(CLI::App& root) {
    struct Given {
        LessonsCommand command;
        std::string context{"auto"};
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app = *root.add_subcommand("lessons", "List the lessons, or check some of your own");
    set_up(app,
           "  normalscope lessons\n"
           "  normalscope 1-normal-as-a-point                       the window, in this lesson\n"
           "  normalscope capture '1-normal-as-a-point#3' -o 3.png  what its third step shows\n"
           "  normalscope lessons --check mine.json                 whether its numbers hold and its words fit");
    add_list(
        app, "--check", given->command.files, "FILE",
        "Check these lessons: that their numbers hold, and that their words fit at 1024x768 to 3840x2160; exit code 1 "
        "with the step where something is wrong")
        .allow_extra_args();
    add_lesson_folders(app, given->command.lesson_folders);
    add_context(app, given->context);
    return {&app, [given] {
                LessonsCommand command = given->command;
                command.context = parse_context("--context", given->context);
                return command;
            }};
}

Declared declare_handout(CLI::App& root) {
    struct Given {
        HandoutCommand command;
        std::string output, size{text_of(command.size)}, context{"auto"}, answers{"end"};
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app = *root.add_subcommand("handout", "Write a lesson as one page to print or send");
    set_up(app,
           "  normalscope handout 4-derivation -o derivation.html\n"
           "  normalscope handout all -o course.html --answers none\n"
           "  normalscope handout mine.json -o script.html --notes --answers inline\n"
           "  normalscope handout 1-normal-as-a-point -o lesson.html --live");
    add_lesson(app, given->command.lesson, "; or all, for every built-in one");
    add(app, "-o,--output", given->output, "OUT.html", "The page to write, pictures included; - is standard output")
        .required();
    add(app, "--size", given->size, "WIDTHxHEIGHT", "Size of each picture, in pixels");
    app.add_flag("--live", given->command.live,
                 "Each picture turns into the program when it is touched, in any browser and without a network");
    add(app, "--answers", given->answers, "end|inline|none", "Where the answers to its questions go");
    app.add_flag("--notes", given->command.notes, "With the steps' notes: the lecturer's script");
    add_context(app, given->context);
    return {&app, [given] {
                HandoutCommand command = given->command;
                command.output = parse_output("--output", given->output, Written::Page);
                command.size = parse_size("--size", given->size);
                command.answers = parse_answers("--answers", given->answers);
                command.context = parse_context("--context", given->context);
                return command;
            }};
}

Declared declare_slides(CLI::App& root) {
    struct Given {
        SlidesCommand command;
        std::string folder, size{text_of(command.size)}, context{"auto"};
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app =
        *root.add_subcommand("slides", "Write a lesson as slides: a picture a step, and a page that shows them");
    set_up(app,
           "  normalscope slides 4-derivation -o derivation-slides\n"
           "  normalscope slides mine.json -o mine-slides --size 1280x720 --live");
    add_lesson(app, given->command.lesson);
    add(app, "-o,--output", given->folder, "FOLDER", "A new or empty folder, for 01.png and so on, and index.html")
        .required();
    add(app, "--size", given->size, "WIDTHxHEIGHT", "Size of each picture, in pixels");
    app.add_flag("--live", given->command.live,
                 "In index.html, each picture turns into the program when it is touched");
    add_context(app, given->context);
    return {&app, [given] {
                SlidesCommand command = given->command;
                if (given->folder == "-")
                    throw UsageError("--output " + given->folder + ": slides are several files; name a new folder");
                command.folder = given->folder;
                command.size = parse_size("--size", given->size);
                command.context = parse_context("--context", given->context);
                return command;
            }};
}

Declared declare_quiz(CLI::App& root) {
    struct Given {
        QuizCommand command;
        std::string output, size{text_of(command.size)}, context{"auto"};
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app = *root.add_subcommand("quiz", "Write a lesson's questions, or exercises, as Moodle XML");
    set_up(app,
           "  normalscope quiz 1-normal-as-a-point -o quiz.xml\n"
           "  normalscope quiz all -o course.xml\n"
           "  normalscope quiz exercises:42 -o homework.xml");
    add_lesson(app, given->command.lesson,
               "; or all, for every built-in one; or exercises:SEED, for the first twelve of that set");
    add(app, "-o,--output", given->output, "OUT.xml", "The questions to write, pictures included; - is standard output")
        .required();
    add(app, "--size", given->size, "WIDTHxHEIGHT", "Size of each picture, in pixels");
    add_context(app, given->context);
    return {&app, [given] {
                QuizCommand command = given->command;
                command.output = parse_output("--output", given->output, Written::Xml);
                command.size = parse_size("--size", given->size);
                command.context = parse_context("--context", given->context);
                return command;
            }};
}

Declared declare_animate(CLI::App& root) {
    struct Given {
        AnimateCommand command;
        std::string output, size{text_of(command.size)}, context{"auto"},
            fps = std::to_string(command.frames_per_second), seconds, subtitles;
    };
    const auto given = std::make_shared<Given>();
    CLI::App& app = *root.add_subcommand("animate", "Draw a lesson as a video, with its captions");
    set_up(app,
           "  normalscope animate 1-normal-as-a-point -o lesson.mp4 --subtitles lesson.vtt\n"
           "  normalscope animate mine.json -o frames/ --size 640x360 --fps 10");
    add_lesson(app, given->command.lesson);
    add(app, "-o,--output", given->output, "OUT",
        "With ffmpeg installed, a .gif, .mp4 or .webm; or frame-%06d.png, where %06d becomes the picture's number; or "
        "a folder")
        .required();
    add(app, "--size", given->size, "WIDTHxHEIGHT", "In pixels");
    add(app, "--fps", given->fps, "N", "Pictures per second");
    CLI::Option& seconds = add(app, "--seconds", given->seconds, "N",
                               "How long each step stands still, 1 to 60 [as long as its words take to read]");
    CLI::Option& subtitles = add(app, "--subtitles", given->subtitles, "OUT.vtt",
                                 "Write the words and their times as subtitles; or OUT.srt");
    add_context(app, given->context);
    return {&app, [given, &seconds, &subtitles] {
                AnimateCommand command = given->command;
                command.output = parse_numbered_output("--output", given->output, 2, 1);
                command.size = parse_size("--size", given->size);
                command.context = parse_context("--context", given->context);
                command.frames_per_second = parse_count("--fps", given->fps, 60);
                if (seconds.count() > 0) command.seconds = parse_count("--seconds", given->seconds, 60);
                if (subtitles.count() > 0) command.subtitles = parse_subtitles_output("--subtitles", given->subtitles);
                return command;
            }};
}

}  // namespace normalscope

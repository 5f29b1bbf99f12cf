#include "animate.h"
#include "capture.h"
#include "check.h"
#include "cli/options.h"
#include "compare.h"
#include "core/error.h"
#include "core/exercise.h"
#include "core/explanation.h"
#include "core/file.h"
#include "core/lesson.h"
#include "core/png.h"
#include "core/scene_file.h"
#include "handout.h"
#include "scene_arguments.h"
#include "sweep.h"
#include "vector_capture.h"
#include "viewer.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <string>

namespace normalscope {

namespace {

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 1, width), ' ');
    return text;
}

int run(const Printed& command) {
    write_file("/dev/stdout", command.text);  // says so where it cannot be written
    return 0;
}

int run(const ScenesCommand&) {
    const std::vector<BuiltInScene> scenes = built_in_scenes();
    std::size_t width = 0;
    for (const BuiltInScene& scene : scenes) width = std::max(width, scene.name.size() + 2);
    std::string list;
    for (const BuiltInScene& scene : scenes) list += padded(scene.name, width) + scene.about + "\n";
    write_file("/dev/stdout", list);
    return 0;
}

int run(const LessonsCommand&) {
    std::size_t width = 0;
    for (const BuiltInLesson& lesson : built_in_lessons()) width = std::max(width, lesson.name.size() + 2);
    std::string list;
    for (const BuiltInLesson& lesson : built_in_lessons()) list += padded(lesson.name, width) + lesson.about + "\n";
    write_file("/dev/stdout", list);
    return 0;
}

int run(const HandoutCommand& command) {
    write_file(command.output, handout(command));
    return 0;
}

int run(const AnimateCommand& command) { return animate(command); }

int run(const ViewCommand& command) {
    const std::string file = command.file.value_or("");
    const bool nothing = file.empty() || exercises_name(file);  // exercises are left for the scene before them
    run_viewer(scene_for(nothing ? std::string(kDefaultScene) : file, command.settings), file);
    return 0;
}

int run(const CaptureCommand& command) {
    const Scene scene = scene_for(command.file, command.settings);
    const bool vector = command.output.extension() == ".svg";
    if (vector) write_file(command.output, vector_capture(scene, command));
    if (vector && !command.numbers) return 0;
    const Capture result =
        Studio(command.context).capture(scene, capture_options(command, command.numbers.has_value()));
    if (!vector) write_png(command.output, result.image);
    if (command.numbers) write_file(*command.numbers, result.numbers);
    if (!result.note.empty()) std::fprintf(stderr, "normalscope: %s\n", result.note.c_str());
    return command.expected ? compare_capture(command, result.image) : 0;
}

int run(const SweepCommand& command) { return sweep(command); }

int run(const ExplainCommand& command) {
    write_file("/dev/stdout", explain(scene_for(command.file, command.settings), command.format));
    return 0;
}

int run(const CompareCommand& command) { return compare(command); }
int run(const CheckCommand& command) { return check(command); }

// One line, whatever a file's name holds.
int fail(int code, std::string reason) {
    std::ranges::replace_if(reason, [](unsigned char c) { return std::iscntrl(c); }, ' ');
    std::fprintf(stderr, "normalscope: %s\n", reason.c_str());
    return code;
}

}  // namespace

}  // namespace normalscope

int main(int argc, char** argv) {
    using namespace normalscope;
    try {
        return std::visit([](const auto& command) { return run(command); }, parse_command_line(argc, argv));
    } catch (const UsageError& e) {
        return fail(2, e.what());
    } catch (const ContextError& e) {
        return fail(4, e.what());
    } catch (const std::exception& e) {
        return fail(3, e.what());
    }
}

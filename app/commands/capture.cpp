#include "cli/commands.h"
#include "commands/commands.h"
#include "commands/compare.h"
#include "commands/evidence.h"
#include "commands/files_of_run.h"
#include "commands/scene_arguments.h"
#include "commands/studio.h"
#include "commands/vector_capture.h"
#include "core/base/output.h"
#include "core/image/png.h"
#include "core/scene/scene_json.h"
#include "platform/crash_line.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace normalscope {

namespace {

void refuse_to_overwrite(const CaptureCommand& command, const Scene& scene) {
    FilesOfRun files;
    files.reads_scene(command.file, scene);
    files.writes(command.output, "--output");
    if (command.numbers) files.writes(*command.numbers, "--numbers");
    if (!command.expected) return;
    files.reads(*command.expected, "--expect " + command.expected->string());
    for (const auto& file : evidence_files(command.output.file, *command.expected))
        files.writes(file, file.string() + " (left beside --output where the pictures differ)");
}

}  // namespace

int run(const CaptureCommand& command) {
    const Subject subject = subject_of(command.file, command.settings);
    refuse_to_overwrite(command, subject.scene);
    const bool vector = command.output.file.extension() == ".svg";
    if (vector) write(command.output, vector_capture(subject.scene, command));
    if (vector && subject.scene.color != SurfaceColor::Lit)
        std::fprintf(stderr, "normalscope: an SVG's surfaces are flat, so that color=%s is not in it; a PNG has it\n",
                     std::string(name(subject.scene.color)).c_str());
    if (vector && !command.numbers) return 0;
    const CrashLine crash_line;
    CaptureOptions options = capture_options(command, subject);
    options.numbers = command.numbers.has_value();
    const Capture result = Studio({.context = command.context}).capture(subject.scene, options);
    if (!vector) write(command.output, png_bytes(result.image));
    if (command.numbers) write(*command.numbers, result.numbers);
    for (const std::string& note : result.notes) std::fprintf(stderr, "normalscope: %s\n", note.c_str());
    const int noted = command.fail_on_note && !result.notes.empty() ? 1 : 0;
    return command.expected ? std::max(noted, compare_capture(command, result.image)) : noted;
}

}  // namespace normalscope

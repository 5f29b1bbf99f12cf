#include "cli/commands.h"
#include "commands/commands.h"
#include "commands/compare.h"
#include "commands/evidence.h"
#include "commands/files_of_run.h"
#include "commands/scene_arguments.h"
#include "commands/studio.h"
#include "commands/vector_capture.h"
#include "core/base/output.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/image/png.h"
#include "platform/crash_line.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

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
    const auto told = [&](const std::vector<std::string>& notes) {
        for (const std::string& note : notes) std::fprintf(stderr, "normalscope: %s\n", in_one_line(note).c_str());
        return command.fail_on_note && !notes.empty() ? 1 : 0;
    };
    const bool vector = has_ending(command.output.file.string(), ".svg");
    int noted = 0;
    if (vector) {
        const VectorCapture drawn = vector_capture(subject.scene, command);
        write(command.output, drawn.svg);
        noted = told(drawn.notes);
    }
    if (vector && !command.numbers) return noted;
    const CrashLine crash_line;
    CaptureOptions options = capture_options(command, subject);
    options.numbers = command.numbers.has_value();
    const Capture result = Studio({.context = command.context}).capture(subject.scene, options);
    if (!vector) write(command.output, png_bytes(result.image));
    if (command.numbers) write(*command.numbers, result.numbers);
    if (!vector) noted = told(result.notes);
    return command.expected ? std::max(noted, compare_capture(command, result.image)) : noted;
}

}  // namespace normalscope

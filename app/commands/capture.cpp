#include "cli/commands.h"
#include "commands/commands.h"
#include "commands/compare.h"
#include "commands/scene_arguments.h"
#include "commands/studio.h"
#include "commands/vector_capture.h"
#include "core/base/file.h"
#include "core/image/png.h"

#include <cstdio>

namespace normalscope {

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

}  // namespace normalscope

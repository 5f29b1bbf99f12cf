#include "capture.h"
#include "cli/options.h"
#include "compare.h"
#include "core/error.h"
#include "core/file.h"
#include "core/png.h"
#include "core/scene_json.h"
#include "viewer.h"

#include <cstdio>
#include <exception>

namespace normalscope {

namespace {

Scene scene_for(const std::string& file, const std::vector<std::string>& settings) {
    Scene scene = load_scene(file);
    for (const std::string& setting : settings) scene = with_setting(scene, setting);
    return scene;
}

int run(const Printed& command) {
    std::fputs(command.text.c_str(), stdout);
    return 0;
}

int run(const ScenesCommand&) {
    for (const BuiltInScene& scene : built_in_scenes()) std::printf("%-14s %s\n", scene.name.c_str(), scene.about.c_str());
    return 0;
}

int run(const ViewCommand& command) {
    run_viewer(scene_for(command.file.value_or(std::string(kDefaultScene)), command.settings), command.file.value_or(""));
    return 0;
}

int run(const CaptureCommand& command) {
    const Capture result = capture(scene_for(command.file, command.settings),
                                   {.size = command.size, .samples = command.samples, .context = command.context,
                                    .panel = command.panel, .numbers = command.numbers.has_value()});
    write_png(command.output, result.image);
    if (command.numbers) write_file(*command.numbers, result.numbers);
    return 0;
}

int run(const CompareCommand& command) { return compare(command); }

int fail(int code, const char* reason) {
    std::fprintf(stderr, "normalscope: %s\n", reason);
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

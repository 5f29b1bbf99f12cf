#include "cli/options.h"
#include "commands/commands.h"
#include "commands/scene_arguments.h"
#include "core/base/error.h"
#include "core/lessons/exercise.h"
#include "desktop/desktop.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <string>

namespace normalscope {

namespace {

int run(const ViewCommand& command) {
    const std::string file = command.file.value_or("");
    const bool nothing = file.empty() || exercises_name(file);  // exercises are left for the scene before them
    run_viewer(scene_for(nothing ? std::string(kDefaultScene) : file, command.settings), file);
    return 0;
}

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

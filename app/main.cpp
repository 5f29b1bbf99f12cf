#include "cli/options.h"
#include "commands/commands.h"
#include "core/base/error.h"
#include "core/base/system.h"
#include "core/base/utf8.h"
#include "core/lessons/open.h"
#include "core/lessons/shelf.h"
#include "core/scene/setting.h"
#include "desktop/desktop.h"
#include "platform/console.h"

#include <exception>
#include <new>
#include <string>

namespace normalscope {

namespace {

int run(const ViewCommand& command) {
    std::vector<std::filesystem::path> folders = lesson_folders(command.lesson_folders);
    Opened first{.file = "", .scene = load_scene(std::string(kDefaultScene))};
    if (command.file) first = read_file(*command.file, first.scene);
    for (const std::string& setting : command.settings) first.scene = with_setting(first.scene, setting);
    prepare(first);
    leave_own_console();
    run_viewer(std::move(first), std::move(folders));
    return 0;
}

// One line, whatever a file's name holds.
int fail(int code, const std::string& reason) {
    tell_error("normalscope: " + in_one_line(reason));
    return code;
}

}  // namespace

}  // namespace normalscope

int main(int argc, char** argv) {
    using namespace normalscope;
    begin_process(argc, argv);
    try {
        return std::visit([](const auto& command) { return run(command); }, parse_command_line(argc, argv));
    } catch (const UsageError& e) {
        return fail(2, e.what());
    } catch (const ContextError& e) {
        return fail(4, e.what());
    } catch (const std::bad_alloc&) {
        return fail(3, kOutOfMemory);
    } catch (const std::exception& e) {
        return fail(3, e.what());
    }
}

#include "batch/other_program.h"

#include "core/base/system.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <sstream>

extern "C" char** environ;  // NOLINT(readability-redundant-declaration): a Mac's headers have none

namespace normalscope {

std::optional<std::filesystem::path> find_program(const std::string& name) {
    const std::string path = variable("PATH");
    std::istringstream folders(path.empty() ? "/usr/local/bin:/usr/bin:/bin" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::filesystem::path program = std::filesystem::path(folder) / name;
        if (::access(program.c_str(), X_OK) == 0) return program;
    }
    return std::nullopt;
}

OtherProgram::OtherProgram(const std::vector<std::string>& command, const std::filesystem::path& log) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // of its own
    pid_t process = -1;
    if (::posix_spawn(&process, arguments[0], &actions, &attributes, arguments.data(), environ) == 0)
        process_ = process;
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
}

OtherProgram::~OtherProgram() {
    if (process_ <= 0) return;
    ::kill(static_cast<pid_t>(process_), SIGKILL);
    ::waitpid(static_cast<pid_t>(process_), nullptr, 0);
}

std::optional<int> OtherProgram::ended_within(int milliseconds) {
    if (process_ <= 0) return -1;
    int status = 0;
    const pid_t ended = ::waitpid(static_cast<pid_t>(process_), &status, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR)) {
        ::poll(nullptr, 0, milliseconds);
        return std::nullopt;
    }
    process_ = -1;
    return ended > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace normalscope

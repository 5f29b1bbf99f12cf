#include "batch/job_process.h"

#include "core/base/file.h"
#include "core/base/posix_arguments.h"
#include "core/base/system.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>

extern "C" char** environ;  // NOLINT(readability-redundant-declaration): a Mac's headers have none

namespace normalscope {

namespace {

constexpr const char* kSeat = "NORMALSCOPE_JOB";  // "JOB PIPE WORD": set for a process that is started anew

using OpenFile = std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })>;

// What this process has read on its standard input, for another one to read it there.
OpenFile standard_input_again() {
    const std::string& text = standard_input_so_far();
    OpenFile file(std::tmpfile());
    if (!file || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) return nullptr;
    std::rewind(file.get());
    return file;
}

// With the same arguments, and nothing on its standard output: what it would print the one that started it has printed.
std::optional<pid_t> start_anew(const std::FILE* input) {
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ::fileno(const_cast<std::FILE*>(input)), STDIN_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    const int failed = ::posix_spawn(&process, program_file().c_str(), &actions, nullptr, own_arguments(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    return failed == 0 ? std::optional(process) : std::nullopt;
}

std::optional<JobSeat> seat_of(const std::string& text) {
    std::istringstream words(text);
    JobSeat seat;
    if (!(words >> seat.job >> seat.pipe)) return std::nullopt;
    std::getline(words >> std::ws, seat.word);
    set_variable(kSeat, std::nullopt);
    ::fcntl(seat.pipe, F_SETFD, FD_CLOEXEC);
    return seat;
}

}  // namespace

std::string JobProcess::end() {
    ::close(pipe);
    pipe = -1;
    int status = 0;
    while (::waitpid(static_cast<pid_t>(process), &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status)) return std::string("was ended by a signal (") + ::strsignal(WTERMSIG(status)) + ")";
    return WEXITSTATUS(status) != 0 ? "ended" : "";
}

void JobProcess::stop() const { ::kill(static_cast<pid_t>(process), SIGTERM); }

std::optional<JobProcess> start_job(std::size_t job, const std::string& word) {
    const OpenFile input = standard_input_again();
    std::array<int, 2> ends{};
    if (!input || ::pipe(ends.data()) != 0) return std::nullopt;
    ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    set_variable(kSeat, std::to_string(job) + " " + std::to_string(ends[1]) + " " + word);
    const std::optional<pid_t> process = start_anew(input.get());
    set_variable(kSeat, std::nullopt);
    ::close(ends[1]);
    if (process) return JobProcess{.process = *process, .pipe = ends[0]};
    ::close(ends[0]);
    return std::nullopt;
}

const std::optional<JobSeat>& own_seat() {
    static const std::optional<JobSeat> seat = seat_of(variable(kSeat));
    return seat;
}

std::vector<bool> wait_for_any(std::span<const JobProcess> jobs) {
    std::vector<pollfd> pipes;
    for (const JobProcess& job : jobs) pipes.push_back({job.pipe, POLLIN, 0});  // poll passes over those at -1
    const int ready = ::poll(pipes.data(), static_cast<nfds_t>(pipes.size()), 200);
    std::vector<bool> has_news;
    for (const pollfd& pipe : pipes) has_news.push_back(ready > 0 && pipe.revents != 0);
    return has_news;
}

}  // namespace normalscope

#include "batch/job_process.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace normalscope {

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

std::optional<JobProcess> start_job(std::size_t, const std::string&, std::span<const JobProcess> others,
                                    const std::function<void(int pipe)>& be) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return std::nullopt;
    const pid_t process = ::fork();
    if (process == 0) {
        for (const JobProcess& other : others) ::close(other.pipe);
        ::close(ends[0]);
        be(ends[1]);
        ::_exit(0);
    }
    ::close(ends[1]);
    if (process > 0) return JobProcess{.process = process, .pipe = ends[0]};
    ::close(ends[0]);
    return std::nullopt;
}

const std::optional<JobSeat>& own_seat() {
    static const std::optional<JobSeat> none;
    return none;
}

std::vector<bool> wait_for_any(std::span<const JobProcess> jobs) {
    std::vector<pollfd> pipes;
    for (const JobProcess& job : jobs) pipes.push_back({job.pipe, POLLIN, 0});  // poll passes over those at -1
    const int ready = ::poll(pipes.data(), pipes.size(), 200);
    std::vector<bool> has_news;
    for (const pollfd& pipe : pipes) has_news.push_back(ready > 0 && pipe.revents != 0);
    return has_news;
}

}  // namespace normalscope

#include "batch/jobs.h"

#include "batch/cancel.h"
#include "core/base/error.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

// A job's messages on its pipe: a header and a text. In place of a picture's number stands what kind of error ended it.
struct Header {
    std::uint64_t i;
    std::uint64_t length;
};
constexpr std::uint64_t kUsageError = ~0ull, kContextError = ~1ull, kInputError = ~2ull;

void write_all(int pipe, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(pipe, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) ::_exit(1);  // nobody listens any more
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void send(int pipe, std::uint64_t i, std::string_view text) {
    const Header header{i, text.size()};
    write_all(pipe, {reinterpret_cast<const char*>(&header), sizeof header});
    write_all(pipe, text);
}

[[noreturn]] void rethrow(std::uint64_t kind, const std::string& text) {
    if (kind == kUsageError) throw UsageError(text);
    if (kind == kContextError) throw ContextError(text);
    throw InputError(text);
}

[[noreturn]] void be_a_job(std::size_t job, int pipe,
                           const std::function<void(std::size_t job, const Tell& tell)>& work) {
    try {
        work(job, [&](std::size_t i, const std::string& text) { send(pipe, i, text); });
    } catch (const UsageError& e) {
        send(pipe, kUsageError, e.what());
    } catch (const ContextError& e) {
        send(pipe, kContextError, e.what());
    } catch (const std::exception& e) {
        send(pipe, kInputError, e.what());
    }
    ::_exit(0);  // what this process took over from its parent is the parent's to tidy up
}

/// A job as its parent sees it.
struct Job {
    pid_t process = -1;
    int pipe = -1;
    std::string received;
    bool ended_well = true;

    // False once there is no more to come.
    bool receive() {
        std::array<char, 1 << 16> bytes;
        const ssize_t got = ::read(pipe, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) return true;
        if (got <= 0) return false;
        received.append(bytes.data(), static_cast<std::size_t>(got));
        return true;
    }
    void end() {
        ::close(pipe);
        pipe = -1;
        int status = 0;
        while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        ended_well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }
};

void tell_received(Job& job, const Tell& told) {
    Header header;
    std::size_t at = 0;
    while (job.received.size() - at >= sizeof header) {
        std::memcpy(&header, job.received.data() + at, sizeof header);
        if (job.received.size() - at - sizeof header < header.length) break;
        std::string text = job.received.substr(at + sizeof header, header.length);
        at += sizeof header + header.length;
        if (header.i >= kInputError) rethrow(header.i, text);
        told(header.i, std::move(text));
    }
    job.received.erase(0, at);
}

// Where each job draws with as many threads as there are processors, they are only in each other's way.
void share_processors(std::size_t jobs) {
    const std::size_t each = std::max<std::size_t>(1, std::thread::hardware_concurrency() / jobs);
    ::setenv("LP_NUM_THREADS", std::to_string(each).c_str(), 0);
}

}  // namespace

void run_jobs(std::size_t count, const std::function<void(std::size_t job, const Tell& tell)>& work, const Tell& told) {
    share_processors(count);
    std::fflush(nullptr);  // or each job would write what waits in the buffers once more
    std::vector<Job> jobs(count);
    for (std::size_t j = 0; j < count; ++j) {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0) throw InputError("--jobs: no pipe: " + std::string(std::strerror(errno)));
        jobs[j].process = ::fork();
        if (jobs[j].process == 0) {
            for (const Job& other : jobs)
                if (other.pipe >= 0) ::close(other.pipe);
            ::close(ends[0]);
            be_a_job(j, ends[1], work);
        }
        ::close(ends[1]);
        jobs[j].pipe = ends[0];
        if (jobs[j].process < 0) {
            ::close(ends[0]);
            jobs.resize(j);  // those that there are get on with their share, but it will not be whole
            break;
        }
    }

    std::exception_ptr failure;
    bool stopping = false;
    const auto stop = [&] {
        if (!std::exchange(stopping, true))
            for (const Job& job : jobs)
                if (job.pipe >= 0) ::kill(job.process, SIGTERM);
    };
    if (jobs.size() < count) {
        failure = std::make_exception_ptr(InputError("--jobs " + std::to_string(count) + ": no more than " +
                                                     std::to_string(jobs.size()) + " processes could be started"));
        stop();
    }
    while (std::ranges::any_of(jobs, [](const Job& job) { return job.pipe >= 0; })) {
        std::vector<pollfd> pipes;
        for (const Job& job : jobs) pipes.push_back({job.pipe, POLLIN, 0});  // poll passes over those at -1
        const int ready = ::poll(pipes.data(), pipes.size(), 200);
        if (CancelOnSignal::asked()) stop();
        for (std::size_t j = 0; ready > 0 && j < jobs.size(); ++j) {
            if (pipes[j].revents == 0) continue;
            try {
                const bool more = jobs[j].receive();
                if (!failure) tell_received(jobs[j], told);
                if (more) continue;
                jobs[j].end();
                if (!jobs[j].ended_well && !stopping)
                    throw InputError("--jobs: a process ended before its pictures were drawn; is there enough memory?");
            } catch (...) {
                if (!failure) failure = std::current_exception();
                stop();
            }
        }
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace normalscope

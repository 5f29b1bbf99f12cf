#include "batch/jobs.h"

#include "batch/cancel.h"
#include "batch/job_process.h"
#include "core/base/beside.h"
#include "core/base/error.h"
#include "core/base/utf8.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <string_view>
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

constexpr std::size_t kAtOnce = std::size_t{1} << 16;

void write_all(int pipe, std::string_view bytes) {
    while (!bytes.empty()) {
        const auto written = ::write(pipe, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), kAtOnce)));
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

[[noreturn]] void be_a_job(std::size_t job, int pipe, const Work& work) {
    try {
        work(job, [&](std::size_t i, const std::string& text) { send(pipe, i, text); });
    } catch (const UsageError& e) {
        send(pipe, kUsageError, e.what());
    } catch (const ContextError& e) {
        send(pipe, kContextError, e.what());
    } catch (const std::bad_alloc&) {
        send(pipe, kInputError, kOutOfMemory);
    } catch (const std::exception& e) {
        send(pipe, kInputError, e.what());
    }
    // What is made before run_jobs belongs to the parent, which tidies it up. A job told to stop early has not ended
    // well, unless the parent has been told, too.
    ::_exit(CancelOnSignal::asked() ? 1 : 0);
}

/// A job as its parent sees it.
struct Job {
    JobProcess process;
    std::string received{};

    // False once there is no more to come.
    bool receive() {
        std::array<char, kAtOnce> bytes;
        const auto got = ::read(process.pipe, bytes.data(), static_cast<unsigned>(bytes.size()));
        if (got < 0 && errno == EINTR) return true;
        if (got <= 0) return false;
        received.append(bytes.data(), static_cast<std::size_t>(got));
        return true;
    }
    // Each message is taken before it is looked at, since what it says may be thrown.
    std::optional<std::pair<std::uint64_t, std::string>> next() {
        Header header;
        if (received.size() < sizeof header) return std::nullopt;
        std::memcpy(&header, received.data(), sizeof header);
        if (received.size() - sizeof header < header.length) return std::nullopt;
        std::string text = received.substr(sizeof header, header.length);
        received.erase(0, sizeof header + header.length);
        return std::pair{header.i, std::move(text)};
    }
};

/// All jobs of one run_jobs. Each draws until it has ended, whatever becomes of the others' errors.
class Jobs {
public:
    Jobs(std::size_t count, const std::string& word) {
        while (jobs_.size() < count) {
            const auto started = start_job(jobs_.size(), word);
            if (!started) break;
            jobs_.push_back({*started});
        }
        if (jobs_.size() == count) return;
        note(InputError("--jobs " + std::to_string(count) + ": no more than " + std::to_string(jobs_.size()) +
                        " processes could be started"));
        stop();  // they get on with their share, but it will not be whole
    }

    /// Until all have ended. Throws the first error that there was.
    void listen(const Tell& told) {
        while (std::ranges::any_of(jobs_, [](const Job& job) { return job.process.pipe >= 0; })) {
            const std::vector<bool> has_news = wait_for_any(processes());
            if (CancelOnSignal::asked()) stop();
            for (std::size_t j = 0; j < jobs_.size(); ++j)
                if (has_news[j]) listen_to(jobs_[j], told);
        }
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    std::vector<JobProcess> processes() const {
        std::vector<JobProcess> all;
        for (const Job& job : jobs_) all.push_back(job.process);
        return all;
    }

    void listen_to(Job& job, const Tell& told) {
        const bool more = job.receive();
        while (auto message = job.next()) try {
                if (message->first >= kInputError) rethrow(message->first, message->second);
                told(message->first, std::move(message->second));
            } catch (...) {
                if (!failure_) failure_ = std::current_exception();
                stop();
            }
        if (more) return;
        const std::string died = job.process.end();
        if (died.empty() || stopping_ || CancelOnSignal::asked()) return;
        note(InputError("a process that draws " + died + " before it was done; is there enough memory?"));
        stop();
    }

    void note(const InputError& error) {
        if (!failure_) failure_ = std::make_exception_ptr(error);
    }
    void stop() {
        if (!std::exchange(stopping_, true))
            for (const Job& job : jobs_)
                if (job.process.pipe >= 0) job.process.stop();
    }

    std::vector<Job> jobs_;
    std::exception_ptr failure_;
    bool stopping_ = false;
};

}  // namespace

void run_jobs(std::size_t count, const Work& work, const Tell& told, const std::string& word) {
    if (const auto& seat = own_seat()) be_a_job(seat->job, seat->pipe, work);
    Jobs(count, word).listen(told);
}

std::optional<std::string> word_for_jobs() { return own_seat() ? std::optional(own_seat()->word) : std::nullopt; }

}  // namespace normalscope

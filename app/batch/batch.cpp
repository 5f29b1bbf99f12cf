#include "batch/batch.h"

#include "batch/cancel.h"
#include "batch/jobs.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace normalscope {

namespace {

using Done = std::function<void(std::size_t, std::string)>;

/// A thread that finishes pictures while the next ones are drawn.
class Finisher {
public:
    explicit Finisher(const Done& done) : done_(done), thread_([this] { work(); }) {}
    ~Finisher() { end(); }
    Finisher(const Finisher&) = delete;
    Finisher& operator=(const Finisher&) = delete;

    /// Waits while several pictures are waiting already: each holds megabytes.
    void add(std::size_t i, Finish finish) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return waiting_.size() < kMostWaiting || failure_; });
        if (failure_) std::rethrow_exception(failure_);
        waiting_.push_back({i, std::move(finish)});
        changed_.notify_all();
    }
    /// Until all is finished. Throws what finishing threw.
    void wait() {
        end();
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    static constexpr std::size_t kMostWaiting = 3;
    struct Task {
        std::size_t i;
        Finish finish;
    };

    void end() {
        {
            const std::scoped_lock lock(mutex_);
            ended_ = true;
            changed_.notify_all();
        }
        if (thread_.joinable()) thread_.join();
    }
    std::optional<Task> next() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !waiting_.empty() || ended_; });
        if (waiting_.empty()) return std::nullopt;
        Task task = std::move(waiting_.front());
        waiting_.pop_front();
        changed_.notify_all();
        return task;
    }
    void work() {
        try {
            while (const std::optional<Task> task = next()) done_(task->i, task->finish());
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            failure_ = std::current_exception();
            changed_.notify_all();
        }
    }

    const Done& done_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Task> waiting_;
    bool ended_ = false;
    std::exception_ptr failure_;
    std::thread thread_;  // last: it uses all of the above
};

// Every step-th picture from `first` on.
void draw_share(const Batch& batch, std::size_t first, std::size_t step, const Done& done) {
    const auto draw = batch.start();
    Finisher finisher(done);
    for (std::size_t i = first; i < batch.count && !CancelOnSignal::asked(); i += step) finisher.add(i, draw(i));
    finisher.wait();
}

}  // namespace

bool run_batch(const Batch& batch) {
    const auto jobs = std::min(static_cast<std::size_t>(std::max(batch.jobs, 1)), batch.count);
    std::size_t finished = 0;
    const Done done = [&](std::size_t i, std::string text) {
        ++finished;
        batch.done(i, std::move(text));
    };
    if (jobs <= 1)
        draw_share(batch, 0, 1, done);
    else
        run_jobs(jobs, [&](std::size_t job, const Done& tell) { draw_share(batch, job, jobs, tell); }, done);
    return finished == batch.count;
}

}  // namespace normalscope

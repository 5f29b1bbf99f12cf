#include "batch/batch.h"

#include "batch/cancel.h"
#include "batch/jobs.h"
#include "core/base/beside.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace normalscope {

namespace {

using Done = std::function<void(std::size_t, std::string)>;

/// Finishes pictures in the background while the next ones are drawn.
class Finisher {
public:
    explicit Finisher(const Done& done) : done_(done) {}
    ~Finisher() {
        try {
            wait();
        } catch (...) {  // something else has been thrown already
        }
    }
    Finisher(const Finisher&) = delete;
    Finisher& operator=(const Finisher&) = delete;

    /// Waits while several pictures are waiting already: each holds megabytes. Throws what finishing threw.
    void add(std::size_t i, Finish finish) {
        while (!waiting_.empty() && (waiting_.size() >= kMostWaiting || waiting_.front().text.ready())) take_first();
        waiting_.push_back({i, beside(std::move(finish))});
    }
    /// Until all is finished. Throws what finishing threw.
    void wait() {
        while (!waiting_.empty()) take_first();
    }

private:
    static constexpr std::size_t kMostWaiting = 3;
    struct Task {
        std::size_t i;
        Beside<std::string> text;
    };

    void take_first() {
        Task first = std::move(waiting_.front());
        waiting_.pop_front();
        done_(first.i, first.text.get());
    }

    const Done& done_;
    std::deque<Task> waiting_;
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
    if (batch.count == 0) return true;
    const std::size_t jobs = std::clamp<std::size_t>(batch.jobs, 1, batch.count);
    std::size_t finished = 0;
    const Done done = [&](std::size_t i, std::string text) {
        ++finished;
        batch.done(i, std::move(text));
    };
    if (jobs == 1 && !batch.apart)
        draw_share(batch, 0, 1, done);
    else
        run_jobs(jobs, [&](std::size_t job, const Done& tell) { draw_share(batch, job, jobs, tell); }, done);
    return finished == batch.count;
}

}  // namespace normalscope

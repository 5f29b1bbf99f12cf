#include "batch/batch.h"

#include "batch/cancel.h"
#include "batch/jobs.h"
#include "core/base/beside.h"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

namespace normalscope {

namespace {

using Done = std::function<void(std::size_t, std::string)>;

/// Finishes pictures in the background while the next ones are drawn, and tells of each as soon as it and those before it
/// are finished: should this process die, what it has finished is known.
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

    /// Waits while several pictures are waiting already: each holds megabytes. Throws what finishing or telling threw.
    void add(std::size_t i, Finish finish) {
        while (!waiting_.empty() && (waiting_.size() >= kMostWaiting || waiting_.front().ready())) take_first();
        waiting_.push_back(
            beside([this, number = added_++, i, finish = std::move(finish)] { tell(number, i, finish()); }));
    }
    /// Until all is finished. Throws what finishing or telling threw.
    void wait() {
        while (!waiting_.empty()) take_first();
    }

private:
    static constexpr std::size_t kMostWaiting = 3;

    void take_first() {
        Beside<void> first = std::move(waiting_.front());
        waiting_.pop_front();
        first.get();
    }
    void tell(std::size_t number, std::size_t i, std::string text) {
        telling_.run([&] {
            finished_.emplace(number, std::pair(i, std::move(text)));
            for (; finished_.contains(told_); ++told_) {
                auto node = finished_.extract(told_);
                done_(node.mapped().first, std::move(node.mapped().second));
            }
        });
    }

    const Done& done_;
    std::size_t added_ = 0, told_ = 0;  // pictures, counted in the order in which they are drawn
    OneAtATime telling_;
    std::map<std::size_t, std::pair<std::size_t, std::string>> finished_;  // but not told: others before them are not
    std::deque<Beside<void>> waiting_;                                     // last: these tasks end before the rest goes
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
        run_jobs(
            jobs, [&](std::size_t job, const Done& tell) { draw_share(batch, job, jobs, tell); }, done, batch.word);
    return finished == batch.count;
}

}  // namespace normalscope

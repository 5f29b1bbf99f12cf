#include "core/base/beside.h"

#include <future>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace normalscope {

namespace {

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
constexpr bool kHasThreads = false;
#else
constexpr bool kHasThreads = true;
#endif

std::launch policy(Begin begin) {
    if (!kHasThreads || begin == Begin::WhenAsked) return std::launch::deferred;
    return std::launch::async;
}

}  // namespace

struct BackgroundTask::Thread {
    std::future<void> end;
};

BackgroundTask::BackgroundTask(std::function<void()> work, Begin begin) try
    : thread_(std::make_unique<Thread>(Thread{std::async(policy(begin), std::move(work))})) {
} catch (const std::system_error&) {
    // Mesa would wait for ever for threads that it cannot have.
    throw std::runtime_error(
        "no more threads can be started; raise the limit on memory (ulimit -v) or processes (ulimit -u)");
}
BackgroundTask::~BackgroundTask() = default;  // as that of std::async's futures
BackgroundTask::BackgroundTask(BackgroundTask&&) noexcept = default;
BackgroundTask& BackgroundTask::operator=(BackgroundTask&&) noexcept = default;

bool BackgroundTask::ready(std::chrono::milliseconds patience) const {
    return thread_->end.wait_for(patience) != std::future_status::timeout;
}
void BackgroundTask::finish() { thread_->end.get(); }

struct OneAtATime::Lock {
    std::mutex mutex;
};

OneAtATime::OneAtATime() : lock_(std::make_unique<Lock>()) {}
OneAtATime::~OneAtATime() = default;

void OneAtATime::run(const std::function<void()>& work) {
    const std::scoped_lock lock(lock_->mutex);
    work();
}

std::size_t processors() { return kHasThreads ? std::max<std::size_t>(std::thread::hardware_concurrency(), 1) : 1; }

}  // namespace normalscope

#pragma once

// Work in the background: the only way to a thread. Where there are no threads (a page in a browser) a task runs when its
// result is asked for, so that whoever writes `beside(task)` need not know.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace normalscope {

/// Processors that this program may use at once; 1 where there are no threads.
std::size_t processors();

/// How many threads `work` is worth, of which one does `a_thread`: at least one, and no more than the machine has or four.
inline std::size_t threads_for(std::size_t work, std::size_t a_thread) {
    return std::clamp<std::size_t>(work / a_thread, 1, std::min<std::size_t>(processors(), 4));
}

/// Tells a task that nobody waits for its result any more: a long one looks now and then, and ends early.
class Stop {
public:
    Stop() = default;  ///< never asks
    bool asked() const { return flag_ && flag_->load(std::memory_order_relaxed); }

private:
    template <class>
    friend class Beside;
    std::shared_ptr<std::atomic<bool>> flag_;
};

enum class Begin {
    AtOnce,
    WhenAsked  ///< in the thread that asks; never where nobody does
};

/// A task without a result, in a thread of its own; Beside gives it one.
class BackgroundTask {
public:
    BackgroundTask(std::function<void()> work, Begin begin);  ///< throws std::runtime_error where no thread can be had
    ~BackgroundTask();                                        ///< waits for its end
    BackgroundTask(BackgroundTask&&) noexcept;
    BackgroundTask& operator=(BackgroundTask&&) noexcept;
    bool ready(std::chrono::milliseconds patience) const;
    void finish();  ///< waits for its end, and throws what the work threw

private:
    struct Thread;
    std::unique_ptr<Thread> thread_;
};

/// What several tasks do, one after the other.
class OneAtATime {
public:
    OneAtATime();
    ~OneAtATime();
    OneAtATime(const OneAtATime&) = delete;
    OneAtATime& operator=(const OneAtATime&) = delete;
    void run(const std::function<void()>& work);

private:
    struct Lock;
    std::unique_ptr<Lock> lock_;
};

/// What a task in the background will give. Whoever lets go of it asks the task to stop, and waits until it has.
template <class T>
class Beside {
public:
    Beside() = default;  ///< no task
    template <class Work>
    Beside(Work&& work, Begin begin) : result_(std::make_shared<Result>()) {
        result_->stop.flag_ = std::make_shared<std::atomic<bool>>(false);
        // In a shared_ptr, since a std::function asks for what can be copied.
        auto shared = std::make_shared<std::decay_t<Work>>(std::forward<Work>(work));
        task_.emplace(
            [shared, &result = *result_] {
                const auto run = [&] {
                    if constexpr (std::invocable<std::decay_t<Work>&, const Stop&>)
                        return (*shared)(result.stop);
                    else
                        return (*shared)();
                };
                if constexpr (std::is_void_v<T>)
                    run();
                else
                    result.value.emplace(run());
            },
            begin);
    }
    ~Beside() { let_go(); }
    Beside(Beside&& other) noexcept = default;
    Beside& operator=(Beside&& other) noexcept {
        let_go();
        result_ = std::move(other.result_);
        task_ = std::exchange(other.task_, std::nullopt);
        return *this;
    }

    /// Whether there is a task whose result has not been taken.
    explicit operator bool() const { return result_ != nullptr; }
    /// Whether get() would give its result without waiting for another thread; waits for that as long as `patience`.
    bool ready(std::chrono::milliseconds patience = {}) const { return task_->ready(patience); }
    /// Waits for the result and takes it; there is no task any more. Throws what the task threw.
    T get() {
        const std::shared_ptr<Result> result = std::move(result_);
        BackgroundTask task = *std::exchange(task_, std::nullopt);
        task.finish();
        if constexpr (!std::is_void_v<T>) return std::move(*result->value);
    }

private:
    struct Result {
        Stop stop;
        std::optional<std::conditional_t<std::is_void_v<T>, std::monostate, T>> value;
    };
    void let_go() {
        if (result_) result_->stop.flag_->store(true, std::memory_order_relaxed);
        task_.reset();
    }

    std::shared_ptr<Result> result_;      // at a place that stays when this moves
    std::optional<BackgroundTask> task_;  // last: it ends before its result goes
};

/// Begins a task, which may take a `const Stop&`. What it refers to must live as long as what is given back.
template <class Work>
[[nodiscard]] auto beside(Work&& work, Begin begin = Begin::AtOnce)
    requires std::invocable<std::decay_t<Work>&> || std::invocable<std::decay_t<Work>&, const Stop&>
{
    if constexpr (std::invocable<std::decay_t<Work>&, const Stop&>)
        return Beside<std::invoke_result_t<std::decay_t<Work>&, const Stop&>>(std::forward<Work>(work), begin);
    else
        return Beside<std::invoke_result_t<std::decay_t<Work>&>>(std::forward<Work>(work), begin);
}

/// work(part, begin, end) for each of so many parts of 0 to `count`, each in a thread of its own, until all are done. Parts begin
/// at multiples of `step`.
template <class Work>
void in_parts(std::size_t parts, std::size_t count, const Work& work, std::size_t step = 1) {
    const auto begin_of = [&](std::size_t part) { return part == parts ? count : count / step * part / parts * step; };
    std::vector<Beside<void>> others;
    for (std::size_t part = 1; part < parts; ++part)
        others.push_back(beside([&, part] { work(part, begin_of(part), begin_of(part + 1)); }));
    work(0, begin_of(0), begin_of(1));
    for (Beside<void>& other : others) other.get();
}

}  // namespace normalscope

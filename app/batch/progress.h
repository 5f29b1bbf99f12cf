#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace normalscope {

/// How far a long task is, on standard error: a bar on a terminal; elsewhere, as in a job's log, a line every few seconds.
class Progress {
public:
    /// `what` is counted.
    explicit Progress(std::size_t total, std::string what = "pictures");
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step() { reach(done_ + 1); }
    void reach(std::size_t done);
    /// Takes the bar away, until the next step, before something else is printed.
    void hide();

private:
    using Clock = std::chrono::steady_clock;
    std::string remaining() const;

    std::size_t total_, done_ = 0;
    std::string what_;
    bool terminal_;
    Clock::time_point began_ = Clock::now(), shown_ = began_;
};

}  // namespace normalscope

#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace normalscope {

/// How far a long task is, on standard error: a bar on a terminal; elsewhere, as in a job's log, a line every few seconds.
class Progress {
public:
    explicit Progress(std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step();

private:
    using Clock = std::chrono::steady_clock;
    std::string remaining() const;

    std::size_t total_, done_ = 0;
    bool terminal_;
    Clock::time_point began_ = Clock::now(), shown_ = began_;
};

}  // namespace normalscope

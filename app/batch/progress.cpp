#include "batch/progress.h"

#include "core/base/system.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace normalscope {

Progress::Progress(std::size_t total, std::string what)
    : total_(total), what_(std::move(what)), terminal_(is_terminal(stderr)) {}

Progress::~Progress() { hide(); }

void Progress::hide() {
    if (!terminal_ || shown_ == began_) return;
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
}

std::string Progress::remaining() const {
    const std::chrono::duration<double> taken = Clock::now() - began_;
    const double each = taken.count() / static_cast<double>(done_);
    const auto seconds = static_cast<long>(std::ceil(each * static_cast<double>(total_ - done_)));
    if (seconds < 90) return std::to_string(seconds) + " s left";
    return std::to_string((seconds + 30) / 60) + " min left";
}

void Progress::reach(std::size_t done) {
    if (done == 0 || done > total_) return;
    done_ = done;
    const auto now = Clock::now();
    const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(3000);
    if (now - shown_ < pause) return;
    shown_ = now;
    const std::string line = std::to_string(done_) + " of " + std::to_string(total_) + " " + what_ + ", " + remaining();
    if (!terminal_) {
        std::fprintf(stderr, "%s\n", line.c_str());
        return;
    }
    constexpr std::size_t kWidth = 30;
    const std::size_t filled = kWidth * done_ / total_;
    std::string bar;
    for (std::size_t i = 0; i < kWidth; ++i) bar += i < filled ? "█" : "░";
    std::fprintf(stderr, "\r\x1b[K%s %s", bar.c_str(), line.c_str());
    std::fflush(stderr);
}

}  // namespace normalscope

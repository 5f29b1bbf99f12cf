#pragma once

// What the benchmarks share.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace normalscope {

class Stopwatch {
public:
    std::chrono::duration<double> seconds() const { return std::chrono::steady_clock::now() - start_; }
    double milliseconds() const { return 1000.0 * seconds().count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace normalscope

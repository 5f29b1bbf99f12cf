#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>

namespace normalscope {

/// How many threads `work` is worth, of which one does `a_thread`: at least one, and no more than the machine has or four.
inline std::size_t threads_for(std::size_t work, std::size_t a_thread) {
    return std::clamp<std::size_t>(work / a_thread, 1, std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
}

}  // namespace normalscope

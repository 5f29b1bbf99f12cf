#pragma once

#include "core/base/beside.h"
#include "core/program/program.h"

#include <cstddef>

namespace normalscope::formulas {

/// work(begin, end) for parts of so many points, each in a thread of its own where a program's steps for them, so many `times`,
/// are worth one. Parts begin at multiples of `together`.
template <class Work>
void points_in_parts(const Program& program, std::size_t points, std::size_t together, const Work& work,
                     std::size_t times = 1) {
    constexpr std::size_t kWorthAThread = 500'000;  // steps of points, some milliseconds
    in_parts(
        threads_for(points * program.size() * times, kWorthAThread), points,
        [&](std::size_t, std::size_t begin, std::size_t end) { work(begin, end); }, together);
}

}  // namespace normalscope::formulas

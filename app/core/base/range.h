#pragma once

#include <limits>

namespace normalscope {

/// The values that a number may take.
struct Range {
    double low, high;
};
inline constexpr Range kAnyNumber{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

}  // namespace normalscope

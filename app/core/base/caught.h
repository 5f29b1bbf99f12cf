#pragma once

#include <cmath>
#include <initializer_list>

namespace normalscope {

/// A number that a hand drags, which catches at those that one means: 0, ½, 1, 2 and −1, where one is no further than `reach`.
inline double caught(double value, double reach) {
    for (const double meant : {0.0, 0.5, 1.0, 2.0, -1.0})
        if (std::abs(value - meant) <= reach) return meant;
    return value;
}

}  // namespace normalscope

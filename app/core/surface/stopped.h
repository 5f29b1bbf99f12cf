#pragma once

#include "core/base/beside.h"

namespace normalscope {

/// Thrown by what makes a surface when it has been asked to stop.
struct Stopped {};

inline void go_on_unless(const Stop& stop) {
    if (stop.asked()) throw Stopped{};
}

}  // namespace normalscope

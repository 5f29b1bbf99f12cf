#pragma once

#include "core/picture/display_scale.h"

#include <cstddef>
#include <map>
#include <string>

namespace normalscope {

/// What one session leaves to the next.
struct Remembered {
    DisplayScale scale;
    std::map<std::string, std::size_t> lessons;  ///< the step at which each was left
};

}  // namespace normalscope

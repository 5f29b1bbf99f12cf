#pragma once

#include "core/picture/display_scale.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace normalscope {

/// What one session leaves to the next.
struct Remembered {
    DisplayScale scale;
    std::map<std::string, std::size_t> lessons;  ///< the step at which each was left
    std::optional<Scene> unsaved{};              ///< where it ended before that was saved
};

}  // namespace normalscope

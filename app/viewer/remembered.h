#pragma once

#include "core/frame/display_scale.h"
#include "core/lessons/unsaved_work.h"
#include "ui/kit/unfolded.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

/// What one session leaves to the next.
struct Remembered {
    DisplayScale scale;
    std::map<std::string, std::size_t> lessons;  ///< the step at which each was left
    Unfolded unfolded;                           ///< of the panel
    std::vector<std::string> recent_files{};     ///< that were opened or saved, the newest first, by whole paths
    bool first = false;                          ///< nobody has been here before
    bool motion = true;                          ///< false: what would move by itself is at its end at once
    std::vector<UnsavedWork> unsaved{};          ///< where it ended before that was saved
};

/// All but the unsaved work as JSON, for whoever keeps it.
std::string remembered_text(const Remembered& remembered);
/// What is missing or damaged is as at first: nobody's work depends on it.
Remembered remembered_of(std::string_view json);

}  // namespace normalscope

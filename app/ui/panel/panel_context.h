#pragma once

#include "core/lessons/lesson.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/requests.h"
#include "ui/kit/side_panel.h"
#include "ui/kit/style.h"
#include "ui/kit/unfolded.h"

#include <cstddef>
#include <map>
#include <span>
#include <string>

namespace normalscope {

/// What the panel's parts look at and act on.
struct PanelContext {
    const Look& look;
    const Frame& frame;
    PixelRect place;  ///< where the panel goes
    const Status& status;
    Requests& requests;
    FileDialog& dialog;
    std::span<const SideTab> tabs;  ///< of the panel at the right
    SideMemory& side;
    bool& help;
    Unfolded& unfolded;
    bool asking;  ///< a lesson's question waits for its answer, which numbers would tell
    std::span<const ListedLesson> shelf;
    const std::map<std::string, std::size_t>& progress;  ///< the step at which each lesson was left
};

/// Logical pixels.
inline constexpr float kPanelWidth = 388.0f;

}  // namespace normalscope

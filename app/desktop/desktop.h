#pragma once

#include "viewer/opening.h"

#include <filesystem>
#include <vector>

namespace normalscope {

/// Opens the window on what was opened and prepared, and returns when it is closed. Throws ContextError where there is no
/// display. `lesson_folders`: where the user keeps lessons.
void run_viewer(Opened first, std::vector<std::filesystem::path> lesson_folders);

}  // namespace normalscope

#pragma once

#include "core/base/font_file.h"

#include <span>
#include <vector>

namespace normalscope {

/// Fonts of this machine that have these letters: by fontconfig, and none where that is not installed; on Windows, those that
/// it brings.
std::vector<FontFile> system_fonts(std::span<const char32_t> letters);

}  // namespace normalscope

#pragma once

#include "core/base/font_file.h"

#include <optional>

namespace normalscope {

/// From the highest ascender to the lowest descender, in ems. Empty where Dear ImGui cannot read the font: it has bitmaps
/// instead of outlines, or outlines of a newer kind, or is cut short.
std::optional<float> height_in_ems(const FontFile& font);

}  // namespace normalscope

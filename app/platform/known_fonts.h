#pragma once

#include "core/base/font_file.h"

#include <filesystem>
#include <span>
#include <vector>

namespace normalscope {

/// A font that a system brings, and the letters that it is taken for.
struct KnownFont {
    const char* file;
    char32_t first, last;
};

/// Those for these letters, from the system's folder; where two have some, the first one gives them. Not every system of the
/// kind brings each.
std::vector<FontFile> known_fonts(const std::filesystem::path& folder, std::span<const KnownFont> known,
                                  std::span<const char32_t> letters);

}  // namespace normalscope

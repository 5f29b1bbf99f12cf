#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

/// A TrueType or OpenType font, as bytes; of a collection, the face of that number.
struct FontFile {
    std::string bytes;
    int face = 0;
};

/// Asks for fonts that have these letters between them, as far as there are any.
using FindFonts = std::function<std::vector<FontFile>(std::span<const char32_t> letters)>;

}  // namespace normalscope

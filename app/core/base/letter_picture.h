#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace normalscope {

/// A letter as pixels. Lengths are in pixels.
struct LetterPicture {
    int width = 0, height = 0;  ///< at least 1
    std::vector<unsigned char>
        cover;             ///< how much of each pixel is the letter's, 255 for all of it; from the top, row by row
    float left = 0.0f;     ///< from where one writes to its left edge
    float above = 0.0f;    ///< from the baseline up to its upper edge
    float advance = 0.0f;  ///< to where one writes the next
};

/// Draws a letter whose em has so many pixels; empty where there is none.
using DrawLetter = std::function<std::optional<LetterPicture>(char32_t letter, float em)>;

}  // namespace normalscope

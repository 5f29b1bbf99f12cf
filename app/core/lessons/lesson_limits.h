#pragma once

#include <cstddef>

namespace normalscope {

// What a step may hold at most, words in characters. Beyond these, words would leave no room for the picture.
inline constexpr std::size_t kLongestCaption = 400, kLongestNote = 240, kLongestChoice = 90, kMostEquations = 3,
                             kMostChoices = 5, kLongestLabel = 40, kMostLabels = 4;
inline constexpr std::size_t kLongestNotes = 4000;  ///< which no picture shows

}  // namespace normalscope

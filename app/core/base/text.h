#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// "one, two, three"
std::string joined(std::span<const std::string> words, std::string_view between = ", ");

/// "one, two or three"
std::string alternatives(std::span<const std::string> words);

/// "1 picture", "2 pictures"
std::string counted(std::size_t count, std::string_view one);

/// The letters A to Z made small; all else, other scripts too, stays.
std::string in_small_letters(std::string text);

/// Whether they are the same but for the case of ASCII letters; `lower` has none but small ones.
inline bool is_word(std::string_view word, std::string_view lower) {
    return std::ranges::equal(word, lower, {},
                              [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
}
/// Whether a file's name ends so, such as in ".png", in any case; `lower` has none but small letters.
bool has_ending(std::string_view name, std::string_view lower);

}  // namespace normalscope

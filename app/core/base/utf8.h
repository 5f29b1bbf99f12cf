#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace normalscope {

/// Columns that UTF-8 text takes, each character taken as one wide.
std::size_t columns(std::string_view utf8);
/// The text filled up with spaces.
std::string padded(std::string_view utf8, std::size_t width);
/// The text with "�" in the place of every control character, line breaks too: it stays one line on a terminal, and does
/// there nothing but be read.
std::string in_one_line(std::string_view utf8);
/// The text cut to so many bytes at most, between two characters, and "…" where something is missing.
std::string shortened(std::string_view utf8, std::size_t most_bytes);

}  // namespace normalscope

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace normalscope {

/// Columns that UTF-8 text takes, each character taken as one wide.
std::size_t columns(std::string_view utf8);
/// The text filled up with spaces.
std::string padded(std::string_view utf8, std::size_t width);

}  // namespace normalscope

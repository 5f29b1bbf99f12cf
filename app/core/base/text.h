#pragma once

#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// "one, two, three"
std::string joined(std::span<const std::string> words, std::string_view between = ", ");

/// "one, two or three"
std::string alternatives(std::span<const std::string> words);

/// The letters A to Z made small; all else, other scripts too, stays.
std::string in_small_letters(std::string text);

}  // namespace normalscope

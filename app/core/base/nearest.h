#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// The name that was probably meant: few letters differ, or the word is a part of it; empty where none comes near.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> names);

}  // namespace normalscope

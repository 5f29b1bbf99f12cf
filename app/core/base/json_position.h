#pragma once

#include <span>
#include <string>
#include <string_view>

namespace normalscope {

/// The line, counted from 1, on which the value begins that a path of keys and indices leads to in JSON text that has
/// been parsed without an error. Where the path leads nowhere, the line of the innermost value that it does lead to.
int json_line(std::string_view text, std::span<const std::string> path);

}  // namespace normalscope

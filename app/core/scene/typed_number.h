#pragma once

#include <optional>
#include <string_view>

namespace normalscope {

/// A number as people type it: 0.5, 0,5, .5, 1/2, 2*3, −√2, pi/4, 30°. Empty where it is none, or none that is finite.
std::optional<double> typed_number(std::string_view text);

}  // namespace normalscope

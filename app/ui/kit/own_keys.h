#pragma once

#include <string>
#include <string_view>

namespace normalscope {

/// Words that name keys, as this system's keyboard has them: on a Mac, Cmd in place of Ctrl.
std::string with_own_keys(std::string_view words);

}  // namespace normalscope

#pragma once

#include <functional>
#include <string>

namespace normalscope {

/// The variables in the environment that tell Mesa what to do and have not been seen to do no harm, as "NAME=value", in one
/// line, where with them a process of its own, made for the purpose, crashes in `attempt`: for some values Mesa does, where
/// it should say what is wrong. Empty where all is well, and where nobody can tell.
std::string crashing_driver_variables(const std::function<void()>& attempt);

}  // namespace normalscope

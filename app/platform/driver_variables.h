#pragma once

#include <functional>
#include <string>

namespace normalscope {

/// The variables in the environment that tell Mesa what to do and have not been seen to do no harm, as "NAME=value", in one
/// line: for some values Mesa crashes, where it should say what is wrong. Empty where there are none.
std::string doubtful_driver_variables();

/// Whether a process of its own, made for the purpose, gets through `attempt` without crashing; what it throws does not
/// count. It says nothing on standard error.
bool survives(const std::function<void()>& attempt);

}  // namespace normalscope

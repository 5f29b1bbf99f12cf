#pragma once

#include <string>

namespace normalscope {

/// For a program with a window: a console that the system has opened for it alone, as where it is started by a click, goes.
void leave_own_console();

/// The line on standard error; or, where nobody could ever read that, as where it was started by a click, in a window.
void tell_error(const std::string& line);

}  // namespace normalscope

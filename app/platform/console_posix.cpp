#include "platform/console.h"

#include <cstdio>

namespace normalscope {

void leave_own_console() {}

void tell_error(const std::string& line) { std::fprintf(stderr, "%s\n", line.c_str()); }

}  // namespace normalscope

#pragma once

#include "cli/commands.h"

namespace normalscope {

/// Throws UsageError.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace normalscope

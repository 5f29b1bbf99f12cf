#pragma once

#include "cli/commands.h"

namespace normalscope {

/// Throws UsageError. An output named "-" comes back as /dev/stdout.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace normalscope

#pragma once

#include "cli/options.h"

namespace normalscope {

/// Compares two pictures and prints one line that says how far they are apart. 0 if they agree, 1 if not.
int compare(const CompareCommand& command);

}  // namespace normalscope

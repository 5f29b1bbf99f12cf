#pragma once

#include "cli/options.h"

namespace normalscope {

/// Many pictures of one scene, one for each value (or pair of values) of what varies. The exit code: 0, or as
/// CancelOnSignal has it.
int sweep(const SweepCommand& command);

}  // namespace normalscope

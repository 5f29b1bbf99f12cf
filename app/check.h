#pragma once

#include "cli/options.h"

namespace normalscope {

/// Draws and judges a manifest's scenes. The exit code: 0 if all pass, 1 if not, or as CancelOnSignal has it.
int check(const CheckCommand& command);

}  // namespace normalscope

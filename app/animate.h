#pragma once

#include "cli/options.h"

namespace normalscope {

/// A lesson from its first step to its last, with its captions, as a video or numbered pictures. The exit code: 0, or as
/// CancelOnSignal has it.
int animate(const AnimateCommand& command);

}  // namespace normalscope

#pragma once

#include "cli/commands.h"

namespace normalscope {

/// Compares a picture just drawn and written with what `--expect` names and prints one line; where it differs, what to look
/// at is left beside it. 0 if they agree, 1 if not.
int compare_capture(const CaptureCommand& command, const Image& actual);

}  // namespace normalscope

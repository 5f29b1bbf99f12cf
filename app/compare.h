#pragma once

#include "cli/options.h"

namespace normalscope {

/// Compares two pictures and prints one line that says how far they are apart. 0 if they agree, 1 if not.
int compare(const CompareCommand& command);
/// The same for a picture just drawn and written, with `--expect`; where it differs, what to look at is left beside it.
int compare_capture(const CaptureCommand& command, const Image& actual);

}  // namespace normalscope

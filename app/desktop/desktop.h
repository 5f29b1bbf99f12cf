#pragma once

#include "viewer/opening.h"

namespace normalscope {

/// Opens the window on what was opened and prepared, and returns when it is closed. Throws ContextError where there is no
/// display.
void run_viewer(Opened first);

}  // namespace normalscope

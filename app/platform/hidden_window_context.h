#pragma once

#include "platform/context.h"

#include <memory>

namespace normalscope {

/// A window that is never shown, for systems whose OpenGL draws only into windows. Throws ContextError.
std::unique_ptr<Context> make_hidden_window_context();

}  // namespace normalscope

#pragma once

#include "platform/context.h"

#include <memory>

namespace normalscope {

/// EGL without a surface: a graphics card where there is one, or else Mesa on the processor. Throws ContextError.
std::unique_ptr<Context> make_egl_context();

}  // namespace normalscope

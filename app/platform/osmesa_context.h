#pragma once

#include "platform/context.h"

#include <memory>

namespace normalscope {

/// Mesa's off-screen interface: draws on the processor, without a display or a driver. Throws ContextError.
std::unique_ptr<Context> make_osmesa_context();

}  // namespace normalscope

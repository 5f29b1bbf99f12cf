#pragma once

#include "core/base/context_choice.h"
#include "platform/context.h"

#include <memory>

namespace normalscope {

/// Asks Mesa's software driver to compile shaders quickly rather than well, unless the user's environment already says
/// something about it: for a single picture, optimising takes longer than it saves. Call it before any thread starts.
void prefer_quick_shader_compilation();

/// A context without a display; Auto takes OSMesa, or else EGL. Both libraries are looked for at run time, since newer
/// Mesa has no OSMesa. Throws ContextError, naming what was tried.
std::unique_ptr<Context> make_offscreen_context(ContextChoice kind);

}  // namespace normalscope

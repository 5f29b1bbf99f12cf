#pragma once

#include "core/context_choice.h"

#include <memory>
#include <string_view>

namespace normalscope {

/// A GL 3.3 core context and where its functions are. Everything that draws loads GL through glad from here, never from
/// a linked libGL, which would be another library than OSMesa.
class Context {
public:
    using Function = void (*)();
    using Loader = Function (*)(const char* name);

    virtual ~Context() = default;
    /// Makes the context current on the calling thread, and loads its functions.
    virtual void make_current() = 0;
    /// "window", "osmesa" or "egl".
    virtual std::string_view name() const = 0;
};

/// Asks Mesa's software driver to compile shaders quickly rather than well, unless the user's environment already says
/// something about it: for a single picture, optimising takes longer than it saves. Call it before any thread starts.
void prefer_quick_shader_compilation();

/// A context without a display; Auto takes OSMesa, or else EGL. Both libraries are looked for at run time, since newer
/// Mesa has no OSMesa. Throws ContextError, naming what was tried.
std::unique_ptr<Context> make_offscreen_context(ContextChoice kind);

}  // namespace normalscope

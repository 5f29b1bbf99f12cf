#pragma once

#include "core/base/context_choice.h"
#include "platform/context.h"

#include <cstddef>
#include <memory>

namespace normalscope {

/// What a context without a display is to be.
struct ContextOptions {
    ContextChoice choice = ContextChoice::Auto;
    /// Shaders compiled quickly rather than well, by Mesa's software driver: for a single picture, optimising takes longer
    /// than it saves.
    bool quick_shaders = false;
    std::size_t threads = 0;  ///< that Mesa's software driver draws with; 0: one a processor
};

/// Auto takes what this system has, in the order of offscreen_ways: OSMesa, or else EGL; on Windows, a window that is never
/// shown. The libraries are looked for at run time, since newer Mesa has no OSMesa. What the
/// user's environment says about shaders and threads counts more than the options. Throws ContextError, naming what was
/// tried. Call it while no other thread looks at the environment.
std::unique_ptr<Context> make_offscreen_context(const ContextOptions& options);

}  // namespace normalscope

#pragma once

#include "core/base/context_choice.h"
#include "core/base/system.h"
#include "platform/context.h"

#include <memory>
#include <span>

namespace normalscope {

/// A way to draw without a window on the screen.
struct OffscreenWay {
    ContextChoice choice;  ///< that asks for it alone; Auto: none does
    const char* word;      ///< which --context takes for that
    const char* name;
    std::unique_ptr<Context> (*make)();
    Missing missing;  ///< where its library is missing
};

/// Those that this system has, in the order in which they are tried.
std::span<const OffscreenWay> offscreen_ways();
/// Where OpenGL draws only into windows: one that is never shown comes first.
std::span<const OffscreenWay> hidden_window_ways();

}  // namespace normalscope

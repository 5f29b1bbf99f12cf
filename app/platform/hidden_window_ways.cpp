#include "platform/offscreen_ways.h"

#include "platform/egl_context.h"
#include "platform/hidden_window_context.h"
#include "platform/osmesa_context.h"

#include <array>

namespace normalscope {

std::span<const OffscreenWay> hidden_window_ways() {
    static constexpr std::array<OffscreenWay, 3> kWays{
        {{ContextChoice::Auto, "auto", "a hidden window", make_hidden_window_context, Missing::OpenGl},
         {ContextChoice::Osmesa, "osmesa", "OSMesa", make_osmesa_context, Missing::Osmesa},
         {ContextChoice::Egl, "egl", "EGL", make_egl_context, Missing::Egl}}};
    return kWays;
}

}  // namespace normalscope

#pragma once

namespace normalscope {

/// Where an off-screen picture's GL context comes from; Auto takes OSMesa, or else EGL.
enum class ContextChoice { Auto, Osmesa, Egl };

}  // namespace normalscope

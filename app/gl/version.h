#pragma once

#include <string>

namespace normalscope {

/// What GL calls itself, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
std::string renderer_name();
/// Such as "3.3 (Core Profile) Mesa 22.3.6".
std::string gl_version();

/// What a shader's first line says.
#ifdef __EMSCRIPTEN__
inline constexpr const char* kGlslVersion = "#version 300 es";
#else
inline constexpr const char* kGlslVersion = "#version 330 core";
#endif

}  // namespace normalscope

#pragma once

// OpenGL's declarations: 3.3, or in a page ES 3.0, which lacks some of that.

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#include <glad/gl.h>
#endif

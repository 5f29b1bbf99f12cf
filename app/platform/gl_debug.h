#pragma once

namespace normalscope {

/// With NORMALSCOPE_GL_DEBUG set, as under the tests, the current context's first error or warning of consequence ends the
/// program with one line that tells it. Every context calls it once GL's functions are loaded.
void watch_for_gl_errors();

}  // namespace normalscope

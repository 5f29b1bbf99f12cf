#pragma once

namespace normalscope {

/// What lies behind a picture: the theme's ground with its grid and shadow, plain white, or nothing.
enum class Ground { Scene, White, Transparent };

}  // namespace normalscope

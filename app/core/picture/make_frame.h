#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

namespace normalscope {

/// What the scene looks like at a given size. `surface` is the scene's (SurfaceCache). Throws InputError as
/// world_from_object does.
Frame make_frame(const Scene& scene, std::shared_ptr<const Surface> surface, const FrameOptions& options);

}  // namespace normalscope

#pragma once

#include "core/picture/frame.h"
#include "core/picture/frame_options.h"

namespace normalscope {

/// Adds what is drawn at the probe: the normals of the rules that the pane shows, the tangent plane with its tangents,
/// a right-angle mark a rule (it closes only where the normal is perpendicular), and the arc between the naive and the
/// true normal with its angle.
void add_probe_marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe, const std::vector<ArrowKind>& kinds,
                     const FrameOptions& options);

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"
#include "core/frame/frame_options.h"

#include <vector>

namespace normalscope {

/// Adds what is drawn at the probe: the normals of the rules that the pane shows, the tangent plane with its tangents,
/// a right-angle mark a rule (it closes only where the normal is perpendicular), the arc between the naive and the true
/// normal, and beside each arrow whose it is and by how much it is off.
void add_probe_marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe, const std::vector<ArrowKind>& kinds,
                     const FrameOptions& options);
/// The radius about the probe, in world units, in which its arrows and its plane are to be seen alone. 0: there are none.
double cleared_by_probe(const Pane& pane, const Scene& scene, const ProbeInWorld& probe, const FrameOptions& options);

}  // namespace normalscope

#pragma once

#include "core/frame/frame_options.h"
#include "core/picture/flat_board.h"

#include <vector>

namespace normalscope {

/// What a flat view draws from the lowest to the highest.
enum FlatLayer {
    kPaperLines = -3,
    kInside,
    kAxisLines,
    kGhostCurve,
    kCurve,
    kQuietArrows,  ///< and four more
    kTangentLine = 8,
    kLegs,
    kAngles,
    kProbeArrows,  ///< and four more
    kProbePoint = 18,
    kHandles,
};

/// How long the normal in object space is at the probe, in world units.
double flat_probe_length(const FlatBoard& board, const Scene& scene, const FrameOptions& options);

/// Adds one tangent, the normals as long beside each other as they come out, with their x and y legs and what each is
/// multiplied by, the angle, the verdicts, and the symbols of the equations.
void add_flat_probe_marks(Pane& pane, const Scene& scene, const Frame& frame, FlatBoard& board,
                          const FrameOptions& options);

}  // namespace normalscope

#pragma once

#include "core/frame/frame.h"
#include "core/image/ground.h"

#include <string>

namespace normalscope {

/// A picture's vector parts, which stay sharp in print at any size: the object's outline and edges, arrows, axes, the
/// probe's marks and arcs, labels and the legend. Flat colours in place of light; what the object hides is left out.
/// `pixel_scale` as the frame was made with.
std::string svg_text(const Scene& scene, const Frame& frame, double pixel_scale, Ground ground);

}  // namespace normalscope

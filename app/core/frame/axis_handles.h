#pragma once

#include "core/math/camera.h"
#include "core/scene/scene.h"

#include <optional>
#include <vector>

namespace normalscope {

/// One of the object's axes, by whose end the object is stretched. It belongs to the stack's first scale, or to one
/// that a drag puts at the stack's beginning.
struct AxisHandle {
    int axis = 0;  ///< 0, 1, 2 for x, y, z
    Point<World> origin;
    Vector<World> unit;   ///< where the knob would be, from the origin, at factor 1
    double factor = 1.0;  ///< the scale's factor now
    Point<World> knob() const { return origin + factor * unit; }
};

/// `extent` is the object's (Surface::extent): the knobs stand a little beyond it. Handles whose direction later entries
/// of the stack have collapsed are left out.
std::vector<AxisHandle> axis_handles(const Scene& scene, const glm::dvec3& extent);

/// The handles that a picture shows: in a flat view, those that lie in its plane.
std::vector<AxisHandle> handles_in_view(const Scene& scene, const glm::dvec3& extent, const CameraView& view);

/// The handle whose knob lies within `reach` pixels; the nearest to the eye of several.
std::optional<AxisHandle> handle_at(const std::vector<AxisHandle>& handles, const CameraView& view, glm::dvec2 pixel,
                                    double reach);

/// The factor that brings the knob nearest to the pixel's ray; empty where the axis points at the eye.
std::optional<double> factor_at(const AxisHandle& handle, const CameraView& view, glm::dvec2 pixel);

/// How far one factor is from another in the picture, at the knob: what a pixel is worth.
double factor_per_pixel(const AxisHandle& handle, const CameraView& view);

/// The scene with that factor for the handle's axis, in hundredths; `uniform` scales all three by the same ratio.
Scene stretched(const Scene& scene, const AxisHandle& handle, double factor, bool uniform);

}  // namespace normalscope

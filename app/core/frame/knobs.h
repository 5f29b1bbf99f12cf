#pragma once

#include "core/math/camera.h"
#include "core/math/transform.h"
#include "core/scene/scene.h"

#include <optional>
#include <vector>

namespace normalscope {

/// What can be dragged in the picture beside the axes: the ray's two ends, in planes parallel to the picture, and the slice
/// plane, along its axis.
struct Knob {
    enum class What { RayFrom, RayToward, Slice } what = What::RayFrom;
    Point<World> at;
    Vector<World> along;  ///< of the slice: M's image of its axis
};

/// A slice has one where the surface is a formula's, and M does not collapse the axis.
std::vector<Knob> knobs(const Scene& scene, const Transform<World, Object>& world_from_object, const CameraView& view);

/// The knob within `reach` pixels; the nearest to the eye of several.
std::optional<Knob> knob_at(const std::vector<Knob>& knobs, const CameraView& view, glm::dvec2 pixel, double reach);

/// The scene with the knob brought under the pixel, in hundredths.
Scene dragged(const Scene& scene, const Knob& knob, const CameraView& view, glm::dvec2 pixel);

}  // namespace normalscope

#pragma once

#include "core/frame/flat_plane.h"
#include "core/math/normal_rules.h"
#include "core/scene/scene.h"
#include "core/surface/flat_cut.h"

#include <glm/vec2.hpp>

#include <memory>
#include <optional>
#include <string>

namespace normalscope {

/// What a flat view shows, as numbers: all that is in the picture is the part of a vector within the plane.
struct FlatView {
    std::shared_ptr<const FlatCut> cut;
    FlatPlane plane;
    /// Of the probe: the curve's normal in object space, of unit length, as (x, y); and what becomes of it, not normalised.
    /// Empty where there is none, or where it is perpendicular to the plane.
    std::optional<glm::dvec2> n_object;
    ByRule<std::optional<glm::dvec2>> normals;
    std::optional<glm::dvec2> truth;    ///< the normal of the curve's image
    std::optional<glm::dvec2> tangent;  ///< the image of the curve's tangent, not normalised
    /// What each rule multiplies a normal's x and y by, where that is all that it does to them.
    ByRule<std::optional<glm::dvec2>> factors;
    std::optional<double> error_degrees;  ///< between the naive and the true one, as seen
    std::string note;                     ///< one sentence about what is not as one would expect; mostly empty
};

/// The view but for the probe. `cut` is the surface's.
FlatView flat_view(std::shared_ptr<const FlatCut> cut, const Transform<World, Object>& world_from_object);

/// Adds what follows from the probe, if there is one, and the note. `right_power` as of normal_map.
void judge(FlatView& view, const Scene& scene, const std::optional<ProbeInWorld>& probe,
           const Transform<World, Object>& world_from_object, double right_power);

/// The cut's point, in object space, whose image is nearest to a pixel of the pane; empty where none is within `reach` pixels.
std::optional<Point<Object>> point_on_cut(const FlatView& view, const Transform<World, Object>& world_from_object,
                                          const CameraView& camera, glm::dvec2 pixel, double reach);

}  // namespace normalscope

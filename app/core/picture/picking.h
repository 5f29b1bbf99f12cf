#pragma once

#include "core/frame/frame.h"

#include <optional>

namespace normalscope {

/// The pane that a pixel of the framebuffer lies in; none outside the picture.
const Pane* pane_at(const Frame& frame, glm::dvec2 pixel);

/// The surface's point that a click means: the site of the arrow within `reach` pixels, or what the ray meets,
/// whichever is nearer to the eye. `pixel` is of the framebuffer.
std::optional<Point<Object>> picked_point(const Frame& frame, const Transform<World, Object>& world_from_object,
                                          glm::dvec2 pixel, double reach);

/// Whether the pixel is on the probe, or near, so that it can be dragged: one that the scene has put somewhere, for any other
/// keeps to the middle of the picture. In a flat view the whole curve will do.
bool holds_probe(const Scene& scene, const Frame& frame, const Transform<World, Object>& world_from_object,
                 glm::dvec2 pixel, double reach);
/// Where a probe is that is dragged to a pixel: on what is seen there or, beside the object, next to it. `pane` is of the frame.
std::optional<Point<Object>> probe_dragged(const Frame& frame, const Pane& pane,
                                           const Transform<World, Object>& world_from_object, glm::dvec2 pixel);

/// The same for one that is moved by so many pixels from where it is; empty where there is no probe.
std::optional<Point<Object>> probe_moved(const Frame& frame, const Transform<World, Object>& world_from_object,
                                         glm::dvec2 by);

/// What the arrow of the probe within `reach` pixels is in the equations.
std::optional<Highlight> highlight_at(const Frame& frame, glm::dvec2 pixel, double reach);

/// A ball around the transformed object.
struct WorldBall {
    Point<World> centre;
    double radius = 0.0;
};
WorldBall bounding_ball(const Mesh& mesh, const Transform<World, Object>& world_from_object);

}  // namespace normalscope

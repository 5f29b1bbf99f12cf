#pragma once

#include "core/math/camera.h"
#include "core/math/transform.h"
#include "core/mesh/mesh.h"
#include "core/scene/scene.h"

#include <array>
#include <optional>
#include <vector>

namespace normalscope {

/// A point of the surface with its normal there (interpolated between the vertices, of unit length) and two unit
/// tangents; (tangent 0, tangent 1, normal) is right-handed.
struct Probe {
    Point<Object> point;
    Normal<Object> normal;
    std::array<Vector<Object>, 2> tangents;
    bool singular = false;  ///< ∇f is zero here, or does not exist: the point has no normal of its own
    /// The neighbour on the surface that a singular point has borrowed its normal from; empty: normal and tangents are 0.
    std::optional<Point<Object>> borrowed_from{};
    /// H in its tangent plane, counterclockwise seen from outside, and the first two of its edges are the tangents, as long
    /// as they are (with_polygon). Empty: there is none.
    std::vector<Point<Object>> polygon{};
    bool has_normal() const { return !singular || borrowed_from; }
};

/// The probe, if it has a normal: what follows from one is empty otherwise.
inline std::optional<Probe> with_normal(const std::optional<Probe>& probe) {
    return probe && probe->has_normal() ? probe : std::nullopt;
}

/// A probe with its tangents, one of which is level where there is a level one. `n` of any length but 0.
Probe probe_with(Point<Object> point, Normal<Object> n);

/// A probe carried to world space by every rule, with the numbers that the panel, `--numbers` and the picture show.
struct ProbeInWorld {
    Probe object;
    Point<World> point;
    std::array<Vector<World>, 2> tangents;         ///< as M sends them there: M3 t where it is affine
    std::vector<Point<World>> polygon;             ///< MH; empty where there is none, or a corner has no image
    ByRule<std::optional<Normal<World>>> normals;  ///< not normalised
    /// n·t for each rule and tangent; empty where the rule gives no normal.
    ByRule<std::optional<std::array<double, 2>>> dots;
    /// The normal of the image, not normalised: the inverse transpose's or, where only that exists, the cofactor's; where
    /// M is not affine, of the Jacobian there, and so no rule's. Empty where the image has none.
    std::optional<Normal<World>> truth;
    bool affine = true;                   ///< M is
    std::optional<double> error_degrees;  ///< between the naive and the true normal; empty where M has no inverse
};

ProbeInWorld in_world(const Probe& probe, const Transform<World, Object>& world_from_object);
/// The same as the scene has it, with what stands in the naive rule's place; `right_power` as of normal_map.
ProbeInWorld in_world(const Probe& probe, const Transform<World, Object>& world_from_object, const Scene& scene,
                      double right_power = -1.0);

}  // namespace normalscope

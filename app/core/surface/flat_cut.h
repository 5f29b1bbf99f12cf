#pragma once

#include "core/surface/curves_joined.h"
#include "core/surface/probe.h"
#include "core/surface/surface.h"

#include <glm/vec2.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace normalscope {

/// Where a surface meets the plane z = 0 of object space, with its normals there: what a flat view draws. Immutable.
struct FlatCut {
    std::vector<Curve> curves;
    /// What closed curves enclose, an odd number of them: quadrilaterals beside each other, x and y.
    std::vector<std::array<glm::dvec2, 4>> inside;
    double length = 0.0;          ///< of all curves
    bool misses_a_sheet = false;  ///< a part of the surface lies in the plane: no curve shows it
};

/// Without curves where the surface does not cross the plane, and where it only touches it or lies in it.
FlatCut flat_cut(const Surface& surface);

/// The cut's point that is nearest to `p`, and the surface's normal there; empty only where there is no cut.
std::optional<Probe> nearest_on_cut(const Surface& surface, const FlatCut& cut, Point<Object> p,
                                    const std::optional<Direction<Object>>& borrow = {});

/// Where the probe stands that nobody has put anywhere: where the cut is met farthest from its middle on the way to
/// (0.8, 0.6), so that neither x nor y alone tells all.
std::optional<Probe> usual_on_cut(const Surface& surface, const FlatCut& cut);

/// Sites along the curves, `spacing` apart as nearly as whole numbers allow.
std::vector<Site> sites_along(const FlatCut& cut, double spacing);

/// Keeps the last one while the surface is the same.
class FlatCutCache {
public:
    std::shared_ptr<const FlatCut> get(const Scene& scene, const std::shared_ptr<const Surface>& surface);

private:
    std::shared_ptr<const Surface> surface_;
    std::shared_ptr<const FlatCut> cut_;
};

}  // namespace normalscope

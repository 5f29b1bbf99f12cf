#pragma once

#include "core/mesh/mesh.h"
#include "core/scene/scene.h"
#include "core/surface/implicit_surface.h"

#include <optional>
#include <vector>

namespace normalscope {

/// A point of f = 0 where ∇f is zero or does not exist, as at a cone's apex: it has no normal, but its neighbours on the
/// surface have.
struct SingularPoint {
    /// Of the ball or cube: how far away the neighbours are that lend their normals.
    static constexpr double kLenders = 0.04;

    Point<Object> at;
    bool undefined = false;  ///< ∇f does not exist there; else it is zero
    /// The normals on a sphere so small that they are as good as limits, curve by curve in order. Empty where no sheet
    /// of the surface comes near.
    std::vector<std::vector<Normal<Object>>> fan;
    /// The largest angle between the normals of any two lenders: how much depends on the choice.
    double spread_degrees = 0.0;
    std::optional<Site> lender;  ///< the one that the scene chooses
};

/// Whether ∇f is zero or does not exist there: zero against what it is a little further away.
bool is_singular(const ImplicitSurface& surface, Point<Object> p);
/// The singular point of the surface that Newton's steps from `p` come to; empty where there is none within
/// `reach`.
std::optional<Point<Object>> singular_near(const ImplicitSurface& surface, Point<Object> p, double reach);

/// The neighbour in the direction nearest to what the scene borrows from.
std::optional<Site> lender(const ImplicitSurface& surface, Point<Object> p, const Direction<Object>& borrow);
/// All about a point that is singular.
SingularPoint singular_point(const ImplicitSurface& surface, Point<Object> p,
                             const std::optional<Direction<Object>>& borrow);

}  // namespace normalscope

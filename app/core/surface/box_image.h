#pragma once

#include "core/math/camera.h"
#include "core/math/transform.h"
#include "core/program/evaluate.h"

namespace normalscope {

// How near whatever lies within a box of object space could be, for TriangleTree::search: never more than what is found there,
// whatever way both were rounded; infinity for what is nowhere.

/// What M divides by less than this has no image, or so far away a one that no ray could be told to meet it: w is 1 where M
/// is affine.
inline constexpr double kNearInfinity = 1e-6;

/// The squared distance between a point and the box.
double squared_gap(const formulas::Box& box, const glm::dvec3& p);

/// In pixels, between one and what the camera sees of the box's image.
double pixels_between(glm::dvec2 pixel, const formulas::Box& box, const Transform<World, Object>& world_from_object,
                      const CameraView& view);

/// Whether the ray is in a box of world space when it has gone so far, or as good as in it.
bool holds(const formulas::Box& box, const Ray<World>& ray, double distance);

/// Boxes as M sends them to world space.
class BoxImage {
public:
    explicit BoxImage(const Transform<World, Object>& world_from_object);
    /// How far a ray goes until it enters the image, in lengths of its direction; 0 within it. What holds() is true for lies
    /// no nearer.
    double entry(const formulas::Box& box, const Ray<World>& ray) const;

private:
    enum class Reach { Nothing, Somewhere, Anywhere };
    Reach send(const formulas::Box& box, formulas::Box& image) const;

    const Transform<World, Object>& m_;
    glm::dmat3 absolute_;  // of M3
};

}  // namespace normalscope

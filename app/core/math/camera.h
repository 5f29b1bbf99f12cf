#pragma once

#include "core/math/direction.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <optional>

namespace normalscope {

/// A half line; `direction` need not be of unit length.
template <class Space>
struct Ray {
    Point<Space> origin;
    Vector<Space> direction;
};

/// A camera that orbits `target`; y is up. At zoom 1 a ball of radius `kFramedRadius` about the target fills the picture.
struct Camera {
    static constexpr double kFramedRadius = 2.6;
    static constexpr double kFieldOfViewDegrees = 30.0;  ///< across the shorter side
    static constexpr double kLeastZoom = 1e-8, kMostZoom = 1e8;

    double azimuth = 30.0;    ///< degrees to the right of looking along −z
    double elevation = 20.0;  ///< degrees above the horizon, −90 to 90
    /// Empty: it is left to what the picture shows (core/picture/framing.h).
    std::optional<double> zoom;
    Point<World> target;

    /// From the target to the eye.
    Direction<World> toward_eye() const { return {azimuth, elevation}; }
    double magnification() const { return zoom.value_or(1.0); }
    /// The radius about the target that fills the picture.
    double reach() const { return kFramedRadius / magnification(); }
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// A camera seen through a picture of a given size in pixels: the matrices and the way back from a pixel to a ray.
class CameraView {
public:
    CameraView(const Camera& camera, glm::dvec2 size);

    const glm::dmat4& clip_from_world() const { return clip_from_world_; }
    /// The same with everything further from the eye by this share of its distance, for the depth buffer alone: nothing
    /// moves in the picture.
    glm::dmat4 clip_from_world_behind(double share) const;
    /// The same view with whatever is as far from the eye as `depth` in it, however far that is.
    CameraView reaching(double depth) const;
    /// The depth in clip space at which floats tell the rays through the picture best: that of the far plane, unless it is
    /// too far from the near one.
    double ray_depth() const;
    Point<World> eye() const { return eye_; }
    /// Unit vectors to the right of and up in the picture.
    Vector<World> right() const;
    Vector<World> up() const;

    /// Pixel (from the top left) to ray, and point to pixel with its depth (distance along the view axis) as z;
    /// z ≤ 0 lies behind the eye.
    Ray<World> ray(glm::dvec2 pixel) const;
    glm::dvec3 pixel(Point<World> p) const;
    /// How many world units a pixel covers at `p`.
    double world_per_pixel(Point<World> p) const;

private:
    void set_depths(double near, double far);

    glm::dvec2 size_;
    double near_ = 0.0, far_ = 0.0;
    Point<World> eye_;
    glm::dmat4 view_from_world_{1.0};
    glm::dmat4 clip_from_world_{1.0};
    double pixels_per_tangent_ = 1.0;
};

/// The same camera, moved so that a ball about `centre` fills the picture.
Camera framed(Camera camera, Point<World> centre, double radius);

/// Whether a ball is within the picture, and not lost in it.
bool has_room_for(const Camera& camera, Point<World> centre, double radius);

}  // namespace normalscope

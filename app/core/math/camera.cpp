#include "core/math/camera.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

CameraView::CameraView(const Camera& camera, glm::dvec2 size) : size_(size) {
    const double half_angle = glm::radians(0.5 * Camera::kFieldOfViewDegrees);
    const double distance = Camera::kFramedRadius / std::sin(half_angle) / camera.magnification();
    const glm::dvec3 toward_eye = camera.toward_eye().vector().xyz;
    // Not lookAt with y up, which fails when looking straight down: the right vector is known from the azimuth alone.
    const double azimuth = glm::radians(camera.azimuth);
    const glm::dvec3 right(std::cos(azimuth), 0.0, -std::sin(azimuth));
    const glm::dvec3 up = glm::cross(toward_eye, right);
    eye_ = {camera.target.xyz + distance * toward_eye};
    const glm::dmat3 view_axes = glm::transpose(glm::dmat3(right, up, toward_eye));
    view_from_world_ = glm::dmat4(view_axes);
    view_from_world_[3] = glm::dvec4(-(view_axes * eye_.xyz), 1.0);

    // The field of view holds across the shorter side, so that a tall picture does not cut the object off.
    const double tangent = std::tan(half_angle);
    pixels_per_tangent_ = 0.5 * std::min(size.x, size.y) / tangent;
    set_depths(0.02 * distance, distance + 60.0);
}

void CameraView::set_depths(double near, double far) {
    near_ = near;
    far_ = far;
    const glm::dvec2 half = 0.5 * size_ / pixels_per_tangent_ * near;
    clip_from_world_ = glm::frustum(-half.x, half.x, -half.y, half.y, near, far) * view_from_world_;
}

CameraView CameraView::reaching(double depth) const {
    constexpr double kMargin = 1.05,
                     kMostRatio = 5e5;  // far : near; beyond, what lies behind shows through at the far end
    CameraView result = *this;
    const double far = kMargin * depth;
    if (far > far_) result.set_depths(std::max(near_, far / kMostRatio), far);
    return result;
}

double CameraView::ray_depth() const {
    constexpr double kFar = 1e4;  // in near planes' distances
    if (far_ <= kFar * near_) return 1.0;
    return (far_ + near_ - 2.0 * far_ / kFar) / (far_ - near_);
}

// At depth w a frustum has clip z = a w + b, so z / w = a + b / w. With w (1 + share) in place of w that is
// (a w + b / (1 + share)) / w: only b changes.
glm::dmat4 CameraView::clip_from_world_behind(double share) const {
    glm::dmat4 clip = clip_from_world_;
    const double b = (clip * glm::dvec4(eye_.xyz, 1.0)).z;
    clip[3].z -= b * share / (1.0 + share);
    return clip;
}

Vector<World> CameraView::right() const {
    return {{view_from_world_[0][0], view_from_world_[1][0], view_from_world_[2][0]}};
}
Vector<World> CameraView::up() const {
    return {{view_from_world_[0][1], view_from_world_[1][1], view_from_world_[2][1]}};
}

Ray<World> CameraView::ray(glm::dvec2 pixel) const {
    const glm::dvec2 tangent = (pixel - 0.5 * size_) / pixels_per_tangent_;
    const glm::dvec3 in_view(tangent.x, -tangent.y, -1.0);
    return {eye_, {glm::normalize(glm::transpose(glm::dmat3(view_from_world_)) * in_view)}};
}

glm::dvec3 CameraView::pixel(Point<World> p) const {
    const glm::dvec3 in_view(view_from_world_ * glm::dvec4(p.xyz, 1.0));
    const double depth = -in_view.z;
    const double scale = pixels_per_tangent_ / (depth == 0.0 ? 1e-12 : depth);
    return {0.5 * size_.x + scale * in_view.x, 0.5 * size_.y - scale * in_view.y, depth};
}

double CameraView::world_per_pixel(Point<World> p) const { return std::abs(pixel(p).z) / pixels_per_tangent_; }

Camera framed(Camera camera, Point<World> centre, double radius) {
    camera.target = centre;
    camera.zoom = std::clamp(Camera::kFramedRadius / std::max(radius, 1e-12), Camera::kLeastZoom, Camera::kMostZoom);
    return camera;
}

bool has_room_for(const Camera& camera, Point<World> centre, double radius) {
    constexpr double kLost = 0.3;  // of the picture
    const double room = camera.reach();
    return glm::distance(camera.target.xyz, centre.xyz) + radius <= room && radius >= kLost * room;
}

}  // namespace normalscope

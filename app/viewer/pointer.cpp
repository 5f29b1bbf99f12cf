#include "viewer/pointer.h"

#include "core/base/caught.h"
#include "core/picture/framing.h"
#include "core/picture/picking.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr double kKnobReach = 11.0;  // logical pixels
constexpr double kArrowReach = 5.0;
constexpr double kClickSlack = 4.0;  // a hand is not that still
constexpr double kCatch = 5.0;
constexpr double kDegreesPerPixel = 0.4;

double wrapped(double degrees) { return std::remainder(degrees, 360.0); }

void pan(Camera& camera, const Pane& pane, glm::dvec2 step, double scale) {
    const double unit = pane.view.world_per_pixel(camera.target) * scale;
    camera.target = camera.target + (-step.x * unit) * pane.view.right() + (step.y * unit) * pane.view.up();
    camera.target.xyz = glm::clamp(camera.target.xyz, glm::dvec3(-1e6), glm::dvec3(1e6));
}

// A knob that has been dragged out of the picture could not be dragged back.
void keep_in_sight(Scene& scene, const Frame& frame, int axis, double margin) {
    const Pane& pane = frame.panes.front();
    const glm::dvec2 low(margin), high = glm::dvec2(pane.rect.size) - margin;
    for (const AxisHandle& handle : axis_handles(scene, frame.surface->extent)) {
        const glm::dvec2 at(pane.view.pixel(handle.knob()));
        if (handle.axis == axis && glm::clamp(at, low, high) != at)
            scene.camera.zoom = std::min(scene.camera.magnification(), framing_zoom(scene, *frame.surface));
    }
}

}  // namespace

void Pointer::press(const Scene& scene, const Frame& frame, PointerButton button, float scale) {
    const Pane* pane = pane_at(frame, at_);
    if (!pane || busy()) return;
    scrolled_ = false;
    moved_ = false;
    pressed_at_ = at_;
    scene_at_press_ = scene;
    drag_ = button.left ? Drag::Orbit : Drag::Pan;
    if (!button.left) return;

    const glm::dvec2 in_pane = at_ - glm::dvec2(pane->rect.origin);
    if (scene.show.axes)
        if (const auto handle = handle_at(handles_in_view(scene, frame.surface->extent, pane->view), pane->view,
                                          in_pane, kKnobReach * scale)) {
            drag_ = Drag::Handle;
            handle_ = handle;
            uniform_ = button.shift;
            hot_axis_ = handle->axis;
            grab_offset_ = handle->factor - factor_at(*handle, pane->view, in_pane).value_or(handle->factor);
            return;
        }
    if (const auto knob =
            knob_at(knobs(scene, world_from_object(scene), pane->view), pane->view, in_pane, kKnobReach * scale)) {
        drag_ = Drag::Knob;
        knob_ = knob;
        knob_offset_ = glm::dvec2(pane->view.pixel(knob->at)) - in_pane;
        return;
    }
    if (button.shift) {
        if (!frame.flat) drag_ = Drag::Light;
    } else if (holds_probe(scene, frame, world_from_object(scene), at_, kKnobReach * scale)) {
        drag_ = Drag::Probe;
    }
}

void Pointer::move(Scene& scene, const Frame& frame, glm::dvec2 pixel, float scale, Hand hand) {
    const glm::dvec2 step = (pixel - at_) / static_cast<double>(scale);
    at_ = pixel;
    scrolled_ = false;
    if (drag_ == Drag::None) {
        hot_axis_.reset();
        if (const Pane* pane = pane_at(frame, at_); pane && scene.show.axes)
            if (const auto handle = handle_at(handles_in_view(scene, frame.surface->extent, pane->view), pane->view,
                                              at_ - glm::dvec2(pane->rect.origin), kKnobReach * scale))
                hot_axis_ = handle->axis;
        return;
    }
    if (!moved_ && glm::length(at_ - pressed_at_) < kClickSlack * scale) return;
    const glm::dvec2 whole_step = moved_ ? step : (at_ - pressed_at_) / static_cast<double>(scale);
    moved_ = true;
    const Pane* pane = pane_at(frame, pressed_at_);
    if (!pane) return;

    Camera& camera = scene.camera;
    switch (drag_) {
        case Drag::Orbit:
            if (frame.flat) return pan(camera, *pane, whole_step, scale);  // a plane has no other side
            camera.azimuth = wrapped(camera.azimuth - kDegreesPerPixel * whole_step.x);
            camera.elevation = std::clamp(camera.elevation + kDegreesPerPixel * whole_step.y, -90.0, 90.0);
            break;
        case Drag::Pan: pan(camera, *pane, whole_step, scale); break;
        case Drag::Light:
            scene.light.azimuth = wrapped(scene.light.azimuth + kDegreesPerPixel * whole_step.x);
            scene.light.elevation = std::clamp(scene.light.elevation - kDegreesPerPixel * whole_step.y, -90.0, 90.0);
            break;
        case Drag::Handle:
            if (const auto factor = factor_at(*handle_, pane->view, at_ - glm::dvec2(pane->rect.origin)))
                scene = stretched(scene_at_press_, *handle_,
                                  hand == Hand::Free ? *factor + grab_offset_
                                                     : caught(*factor + grab_offset_,
                                                              kCatch * scale * factor_per_pixel(*handle_, pane->view)),
                                  uniform_);
            break;
        case Drag::Knob:
            scene = dragged(scene_at_press_, *knob_, pane->view, at_ - glm::dvec2(pane->rect.origin) + knob_offset_);
            break;
        case Drag::Probe:
            if (const auto point = probe_dragged(frame, *pane, world_from_object(scene), at_)) scene.probe = point;
            break;
        case Drag::None: break;
    }
}

void Pointer::release(Scene& scene, const Frame& frame, float scale) {
    if ((drag_ == Drag::Orbit || drag_ == Drag::Probe) && !moved_) {
        if (const auto point = picked_point(frame, world_from_object(scene), at_, kArrowReach * scale))
            scene.probe = point;
    }
    if (drag_ == Drag::Handle && moved_) keep_in_sight(scene, frame, handle_->axis, kKnobReach * scale);
    drag_ = Drag::None;
    handle_.reset();
    knob_.reset();
}

void Pointer::scroll(Scene& scene, double steps) {
    const double zoom = scene.camera.magnification();
    // Far from there one has been brought by a very large or small object, and needs to get about.
    const bool ordinary = zoom >= 0.05 && zoom <= 100.0;
    const double wanted = zoom * std::pow(1.12, steps);
    scene.camera.zoom =
        ordinary ? std::clamp(wanted, 0.05, 100.0) : std::clamp(wanted, Camera::kLeastZoom, Camera::kMostZoom);
    scrolled_ = true;
}

}  // namespace normalscope

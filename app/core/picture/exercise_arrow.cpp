#include "core/picture/exercise_arrow.h"

#include "core/frame/solids.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

double length_of(const Frame& frame, double arrow_length, double pixel_scale) {
    const Pane& pane = frame.panes.front();
    return std::max(4.6 * frame.unit * arrow_length,
                    70.0 * pixel_scale * pane.view.world_per_pixel(frame.probe->point));
}

glm::dvec2 place(const Pane& pane, Point<World> p) {
    return glm::dvec2(pane.rect.origin) + glm::dvec2(pane.view.pixel(p));
}

}  // namespace

void ExerciseArrow::add_to(Frame& frame, double arrow_length, double pixel_scale, const std::string& label) const {
    if (!frame.probe || frame.panes.empty()) return;
    const double length = length_of(frame, arrow_length, pixel_scale);
    const glm::vec3 color = theme_colors(frame.theme).text;
    for (Pane& pane : frame.panes) {
        const double pixel = pixel_scale * pane.view.world_per_pixel(frame.probe->point);
        const double radius = std::max(0.026 * length, 2.0 * pixel);
        const glm::dvec3 base = frame.probe->point.xyz, tip = base + 1.1 * length * direction.xyz;
        add_arrow(pane.solids, base, tip - base, radius, glm::vec4(color, 1.0f));
        add_ball(pane.solids, tip, 2.2 * radius, glm::vec4(color, 1.0f));
        const glm::dvec3 at = pane.view.pixel({tip + 6.0 * radius * direction.xyz});
        if (at.z > 0.0)
            pane.labels.push_back({Label::Role::Axis, glm::vec2(pane.rect.origin) + glm::vec2(at), label, color});
    }
}

bool ExerciseArrow::near(const Frame& frame, double arrow_length, double pixel_scale, glm::dvec2 pixel) const {
    if (!frame.probe || frame.panes.empty()) return false;
    const Pane& pane = frame.panes.front();
    const double length = length_of(frame, arrow_length, pixel_scale);
    const glm::dvec2 base = place(pane, frame.probe->point);
    const glm::dvec2 tip = place(pane, {frame.probe->point.xyz + 1.1 * length * direction.xyz});
    const glm::dvec2 along = tip - base;
    const double t = std::clamp(glm::dot(pixel - base, along) / std::max(glm::dot(along, along), 1e-9), 0.25, 1.0);
    return glm::length(pixel - (base + t * along)) < 14.0 * pixel_scale;
}

void ExerciseArrow::drag_to(const Frame& frame, double arrow_length, double pixel_scale, glm::dvec2 pixel) {
    if (!frame.probe || frame.panes.empty()) return;
    const Pane& pane = frame.panes.front();
    const double radius =
        1.1 * length_of(frame, arrow_length, pixel_scale) / pane.view.world_per_pixel(frame.probe->point);
    const glm::dvec2 way = pixel - place(pane, frame.probe->point);
    const double x = way.x / radius, y = -way.y / radius, out = std::hypot(x, y);
    if (out < 1e-9) return;
    const glm::dvec3 right = pane.view.right().xyz, up = pane.view.up().xyz, back = glm::cross(right, up);
    // Beyond nine tenths it lies in the picture's plane, which a hand would not meet otherwise.
    const double flat = std::min(out / 0.9, 1.0);
    direction = {glm::normalize(flat / out * (x * right + y * up) + std::sqrt(1.0 - flat * flat) * back)};
}

void ExerciseArrow::turn(const Frame& frame, double right_degrees, double up_degrees) {
    if (frame.panes.empty()) return;
    const CameraView& view = frame.panes.front().view;
    const glm::dvec3 right = view.right().xyz, up = view.up().xyz, back = glm::cross(right, up);
    // Left and right turn it round in the picture's plane, as most exercises lie in it; up and down toward the eye.
    const double roll = -glm::radians(right_degrees), tilt = glm::radians(up_degrees);
    glm::dvec3 d = direction.xyz;
    d = d * std::cos(roll) + glm::cross(back, d) * std::sin(roll) + back * glm::dot(back, d) * (1.0 - std::cos(roll));
    const glm::dvec3 flat = d - glm::dot(d, back) * back;
    const double elevation = std::clamp(std::asin(std::clamp(glm::dot(d, back), -1.0, 1.0)) + tilt, -1.55, 1.55);
    const glm::dvec3 along = glm::length(flat) > 1e-9 ? glm::normalize(flat) : up;
    direction = {std::cos(elevation) * along + std::sin(elevation) * back};
}

}  // namespace normalscope

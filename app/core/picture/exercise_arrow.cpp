#include "core/picture/exercise_arrow.h"

#include "core/frame/label_room.h"
#include "core/frame/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

namespace {

// Beyond the tip, or, where another word stands there, beside it.
void add_word(Pane& pane, const std::array<glm::dvec3, 2>& arrow, double tip_radius, double pixel_scale,
              const WantedLabel& word) {
    constexpr auto kRole = Label::Role::Axis;
    constexpr double kGap = 4.0;
    const auto& [base, tip] = arrow;
    const glm::dvec3 from = pane.view.pixel({base}), to = pane.view.pixel({tip});
    if (!(from.z > 0.0 && to.z > 0.0)) return;
    LabelRoom room(pane, pixel_scale);
    room.keep_clear({base, tip, tip_radius});
    const glm::dvec2 way = glm::dvec2(to) - glm::dvec2(from), half = room.half_size(word.text, kRole);
    const glm::dvec2 along = glm::length(way) > 1e-6 ? glm::normalize(way) : glm::dvec2(0.0, -1.0);
    const double ball = tip_radius / pane.view.world_per_pixel({tip});
    const glm::dvec2 place = glm::dvec2(to) + (ball + kGap * pixel_scale + glm::dot(glm::abs(along), half)) * along;
    if (room.is_free(place, word.text, kRole))
        room.put_at(place, word.text, kRole, word.color);
    else
        room.put_beside(word);
}

}  // namespace

void ExerciseArrow::add_to(Frame& frame, double arrow_length, double pixel_scale, const std::string& label) const {
    if (!frame.probe || frame.panes.empty()) return;
    const double length = length_of(frame, arrow_length, pixel_scale);
    const glm::vec3 color = theme_colors(frame.theme).text;
    for (Pane& pane : frame.panes) {
        const double pixel = pixel_scale * pane.view.world_per_pixel(frame.probe->point);
        const double radius = std::max(0.026 * length, 2.0 * pixel), ball = 2.2 * radius;
        const glm::dvec3 base = frame.probe->point.xyz, tip = base + 1.1 * length * direction.xyz;
        add_arrow(pane.solids, base, tip - base, radius, glm::vec4(color, 1.0f));
        add_ball(pane.solids, tip, ball, glm::vec4(color, 1.0f));
        add_word(pane, {base, tip}, ball, pixel_scale, {tip, label, color});
    }
}

void add_object_in_front(Frame& frame, double pixel_scale) {
    constexpr double kNearer = 0.25;  // of the way from the eye
    constexpr int kCorners = 96;
    for (Pane& pane : frame.panes) {
        const auto object_normal =
            std::ranges::find(pane.symbols, Highlight{.symbol = Symbol::NObject}, &SymbolArrow::what);
        if (object_normal == pane.symbols.end()) continue;
        const glm::dvec3 eye = pane.view.eye().xyz;
        const auto nearer = [&](const glm::dvec3& p) { return eye + kNearer * (p - eye); };
        const glm::dvec3 base = object_normal->base, along = object_normal->vector;
        const double pixel = pixel_scale * pane.view.world_per_pixel({base});
        const double radius = ArrowProportions::kOfObject * std::max(0.022 * glm::length(along), 1.7 * pixel);
        add_arrow(pane.solids, nearer(base), kNearer * along, kNearer * radius, glm::vec4(object_normal->color, 1.0f),
                  ArrowLook::Hollow, theme_colors(frame.theme).background_top);
        add_ball(pane.solids, nearer(base), kNearer * 1.8 * radius, glm::vec4(object_normal->color, 1.0f));

        // Where lines from the eye touch the ellipsoid: with it as the unit ball, a circle about the line from the eye to its
        // middle.
        const glm::dvec3 half = frame.surface->extent, from = eye / half;
        const double distance = glm::length(from);
        if (!(distance > 1.0)) continue;
        const glm::dvec3 way = from / distance;
        std::vector<glm::dvec3> outline =
            circle(way / distance, way, std::sqrt(1.0 - 1.0 / (distance * distance)), kCorners);
        for (glm::dvec3& p : outline) p = nearer(half * p);
        add_tube(pane.solids, outline, kNearer * pixel, glm::vec4(object_normal->color, 1.0f), true);
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

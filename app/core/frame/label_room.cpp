#include "core/frame/label_room.h"

#include "core/base/utf8.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

namespace {

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 ab = b - a;
    const double s = glm::clamp(glm::dot(p - a, ab) / std::max(glm::dot(ab, ab), 1e-12), 0.0, 1.0);
    return glm::distance(p, a + s * ab);
}

// How much of a segment lies within a box about 0 (Liang and Barsky, 1984).
double length_within(const glm::dvec2& half, const glm::dvec2& a, const glm::dvec2& b) {
    double from = 0.0, to = 1.0;
    for (glm::length_t i = 0; i < 2; ++i) {
        const double d = b[i] - a[i];
        if (std::abs(d) < 1e-12) {
            if (std::abs(a[i]) > half[i]) return 0.0;
            continue;
        }
        const double s = (-half[i] - a[i]) / d, t = (half[i] - a[i]) / d;
        from = std::max(from, std::min(s, t));
        to = std::min(to, std::max(s, t));
    }
    return to > from ? (to - from) * glm::distance(a, b) : 0.0;
}

}  // namespace

LabelRoom::LabelRoom(Pane& pane, double pixel_scale) : pane_(pane), scale_(pixel_scale) {
    for (const auto& [from, to] : pane.lines) keep_clear(from, to);
    for (const Label& label : pane.labels) {
        Box box{glm::dvec2(label.pixel) - glm::dvec2(pane.rect.origin), half_size(label.text, label.role)};
        if (label.role == Label::Role::Note) box.middle.x += box.half.x;
        taken_.push_back(box);
    }
}

void LabelRoom::keep_clear(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 from = pane_.view.pixel({a}), to = pane_.view.pixel({b});
    if (from.z > 0.0 && to.z > 0.0) lines_.push_back({glm::dvec2(from), glm::dvec2(to)});
}

double LabelRoom::clearance(const glm::dvec2& pixel) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : lines_) least = std::min(least, distance_to_segment(pixel, a, b));
    return least;
}

glm::dvec2 LabelRoom::half_size(const std::string& text, Label::Role role) const {
    const bool small = role == Label::Role::Note || role == Label::Role::Level;
    const bool boxed = role == Label::Role::Side || role == Label::Role::Level;
    const double pad = boxed ? 5.0 : 1.0;
    return scale_ * (glm::dvec2((small ? 3.3 : 3.9) * static_cast<double>(columns(text)), small ? 8.0 : 9.0) + pad);
}

bool LabelRoom::is_free(const glm::dvec2& pixel, const std::string& text, Label::Role role) const {
    const glm::dvec2 half = half_size(text, role);
    return std::ranges::none_of(
        taken_, [&](const Box& box) { return glm::all(glm::lessThan(glm::abs(pixel - box.middle), half + box.half)); });
}

void LabelRoom::put_at(const glm::dvec2& pixel, const std::string& text, Label::Role role, const glm::vec3& color) {
    pane_.labels.push_back({role, glm::vec2(pane_.rect.origin) + glm::vec2(pixel), text, color});
    taken_.push_back({pixel, half_size(text, role)});
}

// What a box hides, in pixels: of lines, of other words, and of itself beyond the pane's edge.
double LabelRoom::overlap(const Box& box) const {
    double hidden = 0.0;
    const glm::dvec2 with_heads = box.half + 5.0 * scale_;  // lines have a width, and arrows more
    for (const auto& [a, b] : lines_) hidden += length_within(with_heads, a - box.middle, b - box.middle);
    for (const Box& other : taken_) {
        const glm::dvec2 common = box.half + other.half - glm::abs(box.middle - other.middle);
        if (common.x > 0.0 && common.y > 0.0) hidden += 2.0 * (common.x + common.y);
    }
    const glm::dvec2 low = box.half - box.middle, high = box.middle + box.half - glm::dvec2(pane_.rect.size);
    for (glm::length_t i = 0; i < 2; ++i) hidden += 4.0 * (std::max(low[i], 0.0) + std::max(high[i], 0.0));
    return hidden;
}

void LabelRoom::put_beside(const glm::dvec3& at, const std::string& text, const glm::vec3& color) {
    const glm::dvec3 pixel = pane_.view.pixel({at});
    if (!(pixel.z > 0.0)) return;
    const glm::dvec2 half = half_size(text, Label::Role::Axis), size(pane_.rect.size), p(pixel);
    if (glm::any(glm::lessThan(p, glm::dvec2(0.0))) || glm::any(glm::lessThan(size, p))) return;
    Box best{p, half};
    double least = std::numeric_limits<double>::infinity();
    for (const double away : {7.0, 15.0, 26.0, 40.0})
        for (int k = 0; k < 16; ++k) {
            // From the upper right on, in turn to either side of it.
            const int turns = k % 2 == 0 ? k / 2 : -(k + 1) / 2;
            const double angle = 0.7 + turns * 0.392699;
            const glm::dvec2 toward(std::cos(angle), -std::sin(angle));
            // So far that the box ends at this distance.
            const Box box{
                p + toward * (scale_ * away) + half * glm::clamp(1.6 * toward, glm::dvec2(-1.0), glm::dvec2(1.0)),
                half};
            const double cost = 4.0 * overlap(box) + away * scale_ + 0.4 * k;
            if (cost < least) least = cost, best = box;
        }
    put_at(best.middle, text, Label::Role::Axis, color);
}

}  // namespace normalscope

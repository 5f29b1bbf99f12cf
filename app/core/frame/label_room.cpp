#include "core/frame/label_room.h"

#include "core/base/utf8.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace normalscope {

namespace {

constexpr double kFarthest = 80.0, kBeyondArrows = 130.0;  ///< of a word from what it names, in logical pixels
constexpr double kAboveTitle = 14.0;                       ///< in logical pixels
constexpr double kMargin = 3.0;                            ///< between a word and a line, in logical pixels
constexpr double kCrossed = 60.0;  ///< what it costs to lie on a line or on another word, however little
constexpr double kInArea = 70.0, kOnArrows = 240.0, kOnObject = 22.0;  ///< what it costs to lie within one

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 ab = b - a;
    const double s = glm::clamp(glm::dot(p - a, ab) / std::max(glm::dot(ab, ab), 1e-12), 0.0, 1.0);
    return glm::distance(p, a + s * ab);
}

// Rather more than they take, in ems of a semibold face: what is set smaller or thinner has air about it.
double width_of(std::string_view text) {
    double width = 0.0;
    std::size_t plain = 0;
    for (const char c : text) {
        if (static_cast<unsigned char>(c) >= 0x80) continue;
        ++plain;
        if (std::string_view(" .,:;'|!il()[]jtfrI").find(c) != std::string_view::npos)
            width += 0.34;
        else if (std::string_view("mwMW@%").find(c) != std::string_view::npos)
            width += 0.92;
        else
            width += c >= 'A' && c <= 'Z' ? 0.68 : 0.6;
    }
    return width + 0.66 * static_cast<double>(columns(text) - std::min(plain, columns(text)));
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Andrew's monotone chain (1979).
std::vector<glm::dvec2> convex_hull(std::vector<glm::dvec2> points) {
    std::ranges::sort(points, [](const auto& a, const auto& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    if (points.size() < 3) return {};
    std::vector<glm::dvec2> hull;
    const auto go_along = [&](const auto& first, const auto& last) {
        const std::size_t before = hull.size() + 1;
        for (auto p = first; p != last; ++p) {
            while (hull.size() > before && cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0)
                hull.pop_back();
            hull.push_back(*p);
        }
        hull.pop_back();
    };
    go_along(points.begin(), points.end());
    go_along(points.rbegin(), points.rend());
    return hull;
}

}  // namespace

// Liang and Barsky, 1984.
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

double share_within(const std::vector<glm::dvec2>& convex, const glm::dvec2& low, const glm::dvec2& high) {
    constexpr int kAcross = 9, kDown = 5;
    if (convex.size() < 3) return 0.0;
    const auto holds = [&](const glm::dvec2& p) {
        bool left = false, right = false;  // of an edge
        for (std::size_t i = 0; i < convex.size() && !(left && right); ++i) {
            const glm::dvec2 &a = convex[i], &b = convex[i + 1 < convex.size() ? i + 1 : 0];
            const double side = cross(b - a, p - a);
            left = left || side > 0.0, right = right || side < 0.0;
        }
        return !(left && right);
    };
    int within = 0;
    for (int i = 0; i < kAcross; ++i)
        for (int k = 0; k < kDown; ++k)
            within += holds(glm::mix(low, high, glm::dvec2(i / (kAcross - 1.0), k / (kDown - 1.0)))) ? 1 : 0;
    return within / static_cast<double>(kAcross * kDown);
}

std::vector<glm::dvec2> outline_of(const Pane& pane, const Surface& surface,
                                   const Transform<World, Object>& world_from_object) {
    constexpr std::size_t kMost = 2000;
    std::vector<glm::dvec2> points;
    const auto add = [&](const glm::dvec3& world) {
        if (const glm::dvec3 pixel = pane.view.pixel({world}); pixel.z > 0.0) points.emplace_back(pixel);
    };
    const std::vector<glm::dvec3>& positions = surface.mesh.positions;
    for (std::size_t i = 0; i < positions.size(); i += 1 + positions.size() / kMost)
        if (const Point<Object> p{positions[i]}; world_from_object.reaches(p)) add(world_from_object(p).xyz);
    const std::vector<Site>& sites = surface.arrows;
    for (const ArrowDraw& draw : pane.arrows)
        for (std::size_t i = 0; sites.size() > kFewArrows && i < sites.size(); i += 1 + sites.size() / kMost)
            if (const auto ends = ends_of(draw, sites[i])) add((*ends)[1]);
    return convex_hull(std::move(points));
}

LabelRoom::LabelRoom(Pane& pane, double pixel_scale) : pane_(pane), scale_(pixel_scale) {
    for (const Stroke& stroke : pane.strokes) keep_clear(stroke);
    for (const std::vector<glm::dvec3>& area : pane.areas) {
        std::vector<glm::dvec2> corners;
        for (const glm::dvec3& corner : area)
            if (const glm::dvec3 p = pane.view.pixel({corner}); p.z > 0.0) corners.emplace_back(p);
        areas_.push_back(std::move(corners));
    }
    for (const Label& label : pane.labels) {
        Box box{glm::dvec2(label.pixel) - glm::dvec2(pane.rect.origin), half_size(label.text, label.role)};
        if (label.role == Label::Role::Note) box.middle.x += box.half.x;
        if (label.role == Label::Role::Title) box.middle.y += kAboveTitle * scale_ + box.half.y;
        taken_.push_back(box);
    }
}

std::optional<StrokeInPixels> in_pixels(const CameraView& view, const Stroke& stroke) {
    const glm::dvec3 from = view.pixel({stroke.a}), to = view.pixel({stroke.b});
    if (!(from.z > 0.0) || !(to.z > 0.0)) return std::nullopt;
    return StrokeInPixels{glm::dvec2(from), glm::dvec2(to), stroke.half_width / view.world_per_pixel({stroke.b})};
}

void LabelRoom::keep_clear(const Stroke& stroke) {
    if (const auto line = in_pixels(pane_.view, stroke)) lines_.push_back(*line);
}

void LabelRoom::keep_clear_of_arrows(std::vector<glm::dvec2> area) { arrows_ = std::move(area); }

double LabelRoom::clearance(const glm::dvec2& pixel) const {
    double least = std::numeric_limits<double>::infinity();
    for (const StrokeInPixels& line : lines_) least = std::min(least, distance_to_segment(pixel, line.a, line.b));
    return least;
}

glm::dvec2 LabelRoom::half_size(const std::string& text, Label::Role role) const {
    if (role == Label::Role::Title) return scale_ * (glm::dvec2(10.0 * width_of(text), 13.0) + glm::dvec2(18.0, 5.0));
    const bool boxed = role == Label::Role::Side || role == Label::Role::Level;
    const double pad = boxed ? 5.0 : 1.0, em = role == Label::Role::Note || role == Label::Role::Level ? 14.0 : 15.0;
    return scale_ * (glm::dvec2(0.5 * em * width_of(text), 0.68 * em) + pad);
}

bool LabelRoom::is_free(const glm::dvec2& pixel, const std::string& text, Label::Role role) const {
    const glm::dvec2 half = half_size(text, role);
    return std::ranges::none_of(
        taken_, [&](const Box& box) { return glm::all(glm::lessThan(glm::abs(pixel - box.middle), half + box.half)); });
}

bool LabelRoom::meets_word(const Stroke& stroke) const {
    const auto line = in_pixels(pane_.view, stroke);
    return line &&
           std::ranges::any_of(taken_, [&](const Box& box) { return line->length_in(box.middle, box.half) > 0.0; });
}

void LabelRoom::put_at(const glm::dvec2& pixel, const std::string& text, Label::Role role, const glm::vec3& color) {
    pane_.labels.push_back({role, glm::vec2(pane_.rect.origin) + glm::vec2(pixel), text, color});
    taken_.push_back({pixel, half_size(text, role)});
}

std::vector<StrokeInPixels> LabelRoom::lines_near(const glm::dvec2& pixel, const glm::dvec2& reach) const {
    std::vector<StrokeInPixels> near;
    for (const StrokeInPixels& line : lines_)
        if (line.length_in(pixel, reach) > 0.0) near.push_back(line);
    return near;
}

// What a box hides, in pixels: of lines, of other words, and of itself beyond the pane's edge.
double LabelRoom::hidden_by(const Box& box, const std::vector<StrokeInPixels>& near) const {
    double hidden = 0.0;
    const auto cover = [&](double length) {
        if (length > 0.0) hidden += kCrossed * scale_ + length;
    };
    for (const StrokeInPixels& line : near) cover(line.length_in(box.middle, box.half + kMargin * scale_));
    for (const Box& other : taken_) {
        const glm::dvec2 common = box.half + other.half - glm::abs(box.middle - other.middle);
        if (common.x > 0.0 && common.y > 0.0) cover(2.0 * (common.x + common.y));
    }
    const glm::dvec2 low = box.half - box.middle, high = box.middle + box.half - glm::dvec2(pane_.rect.size);
    for (glm::length_t i = 0; i < 2; ++i) hidden += 4.0 * (std::max(low[i], 0.0) + std::max(high[i], 0.0));
    return hidden;
}

void LabelRoom::put_beside(const WantedLabel& wanted) {
    const glm::dvec3 pixel = pane_.view.pixel({wanted.at});
    if (!(pixel.z > 0.0)) return;
    const glm::dvec2 half = half_size(wanted.text, Label::Role::Axis), size(pane_.rect.size), p(pixel);
    if (glm::any(glm::lessThan(p, glm::dvec2(0.0))) || glm::any(glm::lessThan(size, p))) return;
    const double farthest = arrows_.empty() ? kFarthest : kBeyondArrows;
    const std::vector<StrokeInPixels> near = lines_near(p, 2.0 * half + (farthest + kMargin) * scale_);
    Box best{p, half};
    double least = wanted.there ? 4.0 * hidden_by(best, near) : std::numeric_limits<double>::infinity();
    for (const double away : {7.0, 15.0, 26.0, 40.0, 58.0, kFarthest, 105.0, kBeyondArrows})
        for (int k = 0; k < 16 && away <= farthest; ++k) {
            // From the upper right on, in turn to either side of it.
            const int turns = k % 2 == 0 ? k / 2 : -(k + 1) / 2;
            const double angle = 0.7 + turns * 0.392699;
            const glm::dvec2 toward(std::cos(angle), -std::sin(angle));
            // So far that the box ends at this distance.
            const Box box{
                p + toward * (scale_ * away) + half * glm::clamp(1.6 * toward, glm::dvec2(-1.0), glm::dvec2(1.0)),
                half};
            const glm::dvec2 low = box.middle - half, high = box.middle + half;
            double cost = scale_ * (away + 0.4 * k);
            if (cost >= least) continue;  // what takes longer to find out only adds to it
            cost += 4.0 * hidden_by(box, near);
            if (cost >= least) continue;
            for (const std::vector<glm::dvec2>& area : areas_) cost += kInArea * scale_ * share_within(area, low, high);
            cost += kOnArrows * scale_ * share_within(arrows_, low, high);
            cost += kOnObject * scale_ * share_within(pane_.outline, low, high);
            if (cost < least) least = cost, best = box;
        }
    put_at(best.middle, wanted.text, Label::Role::Axis, wanted.color);
}

void place_labels(Pane& pane, const Surface& surface, const Transform<World, Object>& world_from_object,
                  double pixel_scale) {
    pane.outline = outline_of(pane, surface, world_from_object);
    LabelRoom room(pane, pixel_scale);
    if (surface.arrows.size() > kFewArrows && !pane.arrows.empty()) room.keep_clear_of_arrows(pane.outline);
    for (const WantedLabel& wanted : pane.wanted) room.put_beside(wanted);
    pane.wanted.clear();
}

}  // namespace normalscope

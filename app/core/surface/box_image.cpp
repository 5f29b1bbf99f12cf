#include "core/surface/box_image.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace normalscope {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeeway = 1e-7;     // of the distance to the box's far side: what a grazing ray makes of rounding
constexpr double kRounding = 1e-14;  // of the numbers that are added

bool is_empty(const formulas::Box& box) { return !(box.low.x <= box.high.x); }

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

glm::dvec3 farther(const glm::dvec3& a, const glm::dvec3& b) { return glm::max(glm::abs(a), glm::abs(b)); }

std::array<Point<Object>, 8> corners(const formulas::Box& box) {
    std::array<Point<Object>, 8> all;
    for (unsigned i = 0; i < 8; ++i)
        for (glm::length_t k = 0; k < 3; ++k) all[i].xyz[k] = (i >> k & 1U) != 0 ? box.high[k] : box.low[k];
    return all;
}

// Whether all of what is between these corners has an image; nothing of it may have one.
enum class Images { All, Some, None };
Images images_between(const Transform<World, Object>& m, const std::array<Point<Object>, 8>& corners) {
    if (m.affine()) return Images::All;
    double least = kInfinity, most = -kInfinity;
    for (const Point<Object>& corner : corners) {
        least = std::min(least, m.w(corner));
        most = std::max(most, m.w(corner));
    }
    return least > kNearInfinity ? Images::All : most > 0.5 * kNearInfinity ? Images::Some : Images::None;
}

}  // namespace

double squared_gap(const formulas::Box& box, const glm::dvec3& p) {
    if (is_empty(box)) return kInfinity;
    const double leeway = kRounding * (largest(p) + largest(farther(box.low, box.high)));
    const glm::dvec3 gap = glm::max(glm::max(box.low - p, p - box.high) - leeway, 0.0);
    return glm::dot(gap, gap);
}

double pixels_between(glm::dvec2 pixel, const formulas::Box& box, const Transform<World, Object>& world_from_object,
                      const CameraView& view) {
    if (is_empty(box)) return kInfinity;
    const std::array<Point<Object>, 8> all = corners(box);
    const Images images = images_between(world_from_object, all);
    if (images != Images::All) return images == Images::Some ? 0.0 : kInfinity;
    glm::dvec3 low(kInfinity), high(-kInfinity);
    for (const Point<Object>& corner : all) {
        const glm::dvec3 at = view.pixel(world_from_object(corner));
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    if (!(low.z > 0.0)) return high.z > 0.0 ? 0.0 : kInfinity;  // some of it, or all, is behind the eye
    const glm::dvec2 gap = glm::max(glm::max(glm::dvec2(low) - pixel, pixel - glm::dvec2(high)), 0.0);
    return std::max(0.0, glm::length(gap) - kLeeway * 1e-2 * largest(farther(low, high)));
}

bool holds(const formulas::Box& box, const Ray<World>& ray, double distance) {
    const glm::dvec3 low = box.low - ray.origin.xyz, high = box.high - ray.origin.xyz,
                     at = distance * ray.direction.xyz;
    const double leeway = kLeeway * largest(farther(low, high));
    for (glm::length_t i = 0; i < 3; ++i)
        if (!(at[i] >= low[i] - leeway && at[i] <= high[i] + leeway)) return false;
    return true;
}

BoxImage::BoxImage(const Transform<World, Object>& world_from_object) : m_(world_from_object) {
    const glm::dmat3 m3(m_.matrix());
    for (glm::length_t i = 0; i < 3; ++i) absolute_[i] = glm::abs(m3[i]);
}

BoxImage::Reach BoxImage::send(const formulas::Box& box, formulas::Box& image) const {
    if (is_empty(box)) return Reach::Nothing;
    if (m_.affine()) {
        const glm::dvec3 centre = 0.5 * (box.low + box.high), half = box.high - centre;
        const glm::dvec3 to = m_(Point<Object>{centre}).xyz;
        const glm::dvec3 reach = absolute_ * (half + kRounding * (glm::abs(centre) + half)) +
                                 kRounding * glm::abs(glm::dvec3(m_.matrix()[3]));
        image = {to - reach, to + reach};
        return Reach::Somewhere;
    }
    const std::array<Point<Object>, 8> all = corners(box);
    const Images images = images_between(m_, all);
    if (images != Images::All) return images == Images::Some ? Reach::Anywhere : Reach::Nothing;
    image = {glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
    for (const Point<Object>& corner : all) {
        const glm::dvec3 to = m_(corner).xyz;
        image = {glm::min(image.low, to), glm::max(image.high, to)};
    }
    return Reach::Somewhere;
}

double BoxImage::entry(const formulas::Box& box, const Ray<World>& ray) const {
    formulas::Box image;
    if (const Reach reach = send(box, image); reach != Reach::Somewhere)
        return reach == Reach::Anywhere ? 0.0 : kInfinity;
    const glm::dvec3 low = image.low - ray.origin.xyz, high = image.high - ray.origin.xyz;
    const double leeway = 2.0 * kLeeway * largest(farther(low, high));
    double enter = 0.0, leave = kInfinity;
    for (glm::length_t i = 0; i < 3; ++i) {
        const double near = low[i] - leeway, far = high[i] + leeway, way = ray.direction.xyz[i];
        if (way == 0.0) {
            if (near > 0.0 || far < 0.0) return kInfinity;
            continue;
        }
        enter = std::max(enter, (way > 0.0 ? near : far) / way);
        leave = std::min(leave, (way > 0.0 ? far : near) / way);
    }
    return enter <= leave ? enter : kInfinity;
}

}  // namespace normalscope

#include "core/picture/drawn_box.h"

#include "core/frame/picture_scale.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace normalscope {

namespace {

/// Grows over the places in a pane's picture of the points that are added.
class Bounds {
public:
    explicit Bounds(const CameraView& view) : view_(view) {}

    void add(const glm::dvec3& world) {
        const glm::dvec3 pixel = view_.pixel({world});
        in_front_ = in_front_ && pixel.z > 0.0;  // not where it is NaN
        low_ = glm::min(low_, glm::dvec2(pixel));
        high_ = glm::max(high_, glm::dvec2(pixel));
    }
    void add_cube(const glm::dvec3& centre, double half) {
        for (int corner = 0; corner < 8; ++corner)
            add(centre + half * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    }
    /// Everything within `reach` of an object that lies in the box from −extent to extent.
    void add_object(const glm::dmat4& world_from_object, const glm::dvec3& extent, double reach) {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            add_cube(in_world(world_from_object, signs * extent), reach);
        }
    }
    /// Where a point goes; what a projective matrix sends beyond infinity counts as behind the eye.
    glm::dvec3 in_world(const glm::dmat4& world_from_object, const glm::dvec3& p) {
        const glm::dvec4 world = world_from_object * glm::dvec4(p, 1.0);
        in_front_ = in_front_ && world.w > 0.0;
        return glm::dvec3(world) / world.w;
    }
    /// In the pane's pixels, cut to the pane.
    PixelRect box(glm::ivec2 size) const {
        constexpr double kMargin = 2.0;  // samples lie beside a pixel's centre, and the driver snaps vertices
        if (!in_front_) return {{0, 0}, size};
        if (!(low_.x <= high_.x)) return {};
        const glm::dvec2 limit(size);
        const glm::ivec2 from(glm::clamp(glm::floor(low_ - kMargin), glm::dvec2(0.0), limit));
        const glm::ivec2 to(glm::clamp(glm::ceil(high_ + kMargin), glm::dvec2(0.0), limit));
        return {from, to - from};
    }

private:
    const CameraView& view_;
    glm::dvec2 low_{std::numeric_limits<double>::infinity()}, high_{-std::numeric_limits<double>::infinity()};
    bool in_front_ = true;
};

bool empty(const PixelRect& rect) { return rect.size.x <= 0 || rect.size.y <= 0; }

// So few points are looked at one by one, every frame; of more, the corners of a box tell enough.
constexpr std::size_t kFew = 5000;

void add_surface(Bounds& bounds, const Mesh& mesh, const glm::dmat4& world_from_object) {
    for (const glm::dvec3& p : mesh.positions) bounds.add(bounds.in_world(world_from_object, p));
}

// Where scene.vert puts them.
void add_arrows(Bounds& bounds, std::span<const Site> sites, const ArrowDraw& draw, double length, double reach) {
    const glm::dmat4 world_from_object(draw.world_from_object);
    for (const Site& site : sites) {
        const glm::dvec3 base = bounds.in_world(world_from_object, site.point.xyz);
        const glm::dvec3 n = draw.normals(site.normal).xyz;
        const glm::dvec3 along = n == glm::dvec3(0.0) ? n : length * glm::normalize(n);
        bounds.add_cube(base, reach);
        bounds.add_cube(base + along, reach);
    }
}

}  // namespace

PixelRect drawn_box(const Surface& surface, const Pane& pane) {
    const glm::dvec3 extent = drawn_extent(surface);
    Bounds bounds(pane.view);
    for (const SurfaceDraw& draw : pane.surfaces)
        if (!surface.implicit && surface.mesh.positions.size() <= kFew)
            add_surface(bounds, surface.mesh, draw.world_from_object);
        else
            bounds.add_object(draw.world_from_object, extent, 0.0);
    for (const ArrowDraw& draw : pane.arrows) {
        const double lengths = draw.normals.at_pixels ? 1.0 : 3.0;  // normals left as long as they come out: scene.vert
        const double length = lengths * double(draw.length), reach = 3.0 * double(draw.radius);
        if (surface.arrows.size() <= kFew)
            add_arrows(bounds, surface.arrows, draw, length, reach);
        else
            bounds.add_object(draw.world_from_object, extent, length + reach);
    }
    for (const auto* solids : {&pane.solids, &pane.translucent})
        for (const SolidVertex& vertex : *solids) bounds.add(vertex.position);
    PixelRect box = bounds.box(pane.rect.size);
    box.origin += pane.rect.origin;
    return box;
}

PixelRect ground_box(const Frame& frame, const Pane& pane) {
    if (!frame.ground_height) return {pane.rect.origin, {0, 0}};
    // As backdrop.frag lets them fade.
    const double grid = frame.unit / std::sqrt(0.021), shadow = 1.0 / std::sqrt(0.3);
    const glm::dmat3 to_shadow(frame.shadow_from_ground);
    const bool casts_shadow = glm::determinant(to_shadow) != 0.0;
    const glm::dmat3 from_shadow = casts_shadow ? glm::inverse(to_shadow) : glm::dmat3(0.0);
    constexpr int kCorners = 16;  // of a polygon around a circle
    const double around = 1.0 / std::cos(std::numbers::pi / kCorners);
    Bounds bounds(pane.view);
    const auto add = [&](const glm::dvec2& at) { bounds.add({at.x, *frame.ground_height, at.y}); };
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kCorners;
        const glm::dvec2 corner = around * glm::dvec2(std::cos(angle), std::sin(angle));
        add(grid * corner);
        if (casts_shadow) add(glm::dvec2(from_shadow * glm::dvec3(shadow * corner, 1.0)));
    }
    PixelRect box = bounds.box(pane.rect.size);
    box.origin += pane.rect.origin;
    return box;
}

PixelRect united(const PixelRect& a, const PixelRect& b) {
    if (empty(a)) return b;
    if (empty(b)) return a;
    const glm::ivec2 low = glm::min(a.origin, b.origin), high = glm::max(a.origin + a.size, b.origin + b.size);
    return {low, high - low};
}

}  // namespace normalscope

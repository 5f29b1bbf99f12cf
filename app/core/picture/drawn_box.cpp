#include "core/picture/drawn_box.h"

#include "core/frame/picture_scale.h"
#include "core/picture/pixel_bounds.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <span>

namespace normalscope {

namespace {

bool empty(const PixelRect& rect) { return rect.size.x <= 0 || rect.size.y <= 0; }

// So few points are looked at one by one, every frame; of more, the corners of a box tell enough.
constexpr std::size_t kFew = 5000;

void add_surface(PixelBounds& bounds, const Mesh& mesh, const glm::dmat4& world_from_object) {
    for (const glm::dvec3& p : mesh.positions) bounds.add(bounds.in_world(world_from_object, p));
}

// Where scene.vert puts them.
void add_arrows(PixelBounds& bounds, std::span<const Site> sites, const ArrowDraw& draw, double length, double reach) {
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
    PixelBounds bounds(pane.view);
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

PixelRect united(const PixelRect& a, const PixelRect& b) {
    if (empty(a)) return b;
    if (empty(b)) return a;
    const glm::ivec2 low = glm::min(a.origin, b.origin), high = glm::max(a.origin + a.size, b.origin + b.size);
    return {low, high - low};
}

}  // namespace normalscope

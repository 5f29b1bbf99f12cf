#include "core/picture/picking.h"

#include "core/surface/singular_point.h"
#include "core/surface/surface_probe.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace normalscope {

namespace {

struct ArrowHit {
    Point<Object> point;
    double depth = std::numeric_limits<double>::infinity();
};

// How far a point of the picture is from a line between two, and how far along it is nearest (0 … 1).
struct Nearness {
    double distance, along;
};
Nearness to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 ab = b - a;
    const double length2 = glm::dot(ab, ab);
    const double s = length2 > 0.0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
    return {glm::length(p - a - s * ab), s};
}

ArrowHit nearest_arrow(const Frame& frame, const Pane& pane, glm::dvec2 pixel, double reach) {
    ArrowHit hit;
    for (const ArrowDraw& draw : pane.arrows)
        for (const Site& site : frame.surface->arrows) {
            const glm::dvec3 direction = draw.normals(site.normal).xyz;
            const glm::dvec4 h = glm::dmat4(draw.world_from_object) * glm::dvec4(site.point.xyz, 1.0);
            if (!(glm::length(direction) > 0.0) || !(h.w > 0.0)) continue;
            const glm::dvec3 base = glm::dvec3(h) / h.w;
            const glm::dvec3 from = pane.view.pixel({base});
            const glm::dvec3 to = pane.view.pixel({base + double(draw.length) * glm::normalize(direction)});
            if (from.z <= 0.0 || to.z <= 0.0) continue;
            const Nearness near = to_segment(pixel, from, to);
            const double depth = glm::mix(from.z, to.z, near.along);
            if (near.distance <= reach && depth < hit.depth) hit = {site.point, depth};
        }
    return hit;
}

}  // namespace

const Pane* pane_at(const Frame& frame, glm::dvec2 pixel) {
    for (const Pane& pane : frame.panes) {
        const glm::dvec2 at = pixel - glm::dvec2(pane.rect.origin);
        if (at.x >= 0.0 && at.y >= 0.0 && at.x < pane.rect.size.x && at.y < pane.rect.size.y) return &pane;
    }
    return nullptr;
}

std::optional<Point<Object>> picked_point(const Frame& frame, const Transform<World, Object>& world_from_object,
                                          glm::dvec2 pixel, double reach) {
    const Pane* pane = pane_at(frame, pixel);
    if (!pane) return std::nullopt;
    const glm::dvec2 at = pixel - glm::dvec2(pane->rect.origin);
    if (frame.flat) return point_on_cut(*frame.flat, world_from_object, pane->view, at, 4.0 * reach);
    const ArrowHit arrow = nearest_arrow(frame, *pane, at, reach);
    const auto surface = first_hit(*frame.surface, world_from_object, pane->view.ray(at));
    const double surface_depth =
        surface ? pane->view.pixel(world_from_object(surface->probe.point)).z : std::numeric_limits<double>::infinity();
    if (arrow.depth <= surface_depth && arrow.depth < std::numeric_limits<double>::infinity()) return arrow.point;
    if (!surface) return std::nullopt;
    // Nobody hits a single point by hand: a singular one so near is meant.
    if (frame.surface->implicit)
        if (const auto singular = singular_near(*frame.surface->implicit, surface->probe.point,
                                                0.2 * frame.surface->implicit->source().bound)) {
            const glm::dvec3 there = pane->view.pixel(world_from_object(*singular));
            if (there.z > 0.0 && glm::distance(glm::dvec2(there), at) < 2.0 * reach) return singular;
        }
    return surface->probe.point;
}

bool holds_probe(const Scene& scene, const Frame& frame, const Transform<World, Object>& world_from_object,
                 glm::dvec2 pixel, double reach) {
    const Pane* pane = pane_at(frame, pixel);
    if (!pane) return false;
    const glm::dvec2 at = pixel - glm::dvec2(pane->rect.origin);
    if (frame.flat && point_on_cut(*frame.flat, world_from_object, pane->view, at, reach)) return true;
    if (!frame.probe || !scene.probe || !scene.show.probe) return false;
    const glm::dvec3 probe = pane->view.pixel(frame.probe->point);
    return probe.z > 0.0 && glm::distance(glm::dvec2(probe), at) <= reach;
}

std::optional<Point<Object>> probe_dragged(const Frame& frame, const Pane& pane,
                                           const Transform<World, Object>& world_from_object, glm::dvec2 pixel) {
    const glm::dvec2 at = pixel - glm::dvec2(pane.rect.origin);
    if (frame.flat)
        return point_on_cut(*frame.flat, world_from_object, pane.view, at, std::numeric_limits<double>::infinity());
    const auto probe = probe_in_view(*frame.surface, world_from_object, pane.view, at);
    return probe ? std::optional(probe->point) : std::nullopt;
}

std::optional<Point<Object>> probe_moved(const Frame& frame, const Transform<World, Object>& world_from_object,
                                         glm::dvec2 by) {
    if (!frame.probe || frame.panes.empty()) return std::nullopt;
    const Pane& pane = frame.panes.front();
    const glm::dvec3 at = pane.view.pixel(frame.probe->point);
    if (!(at.z > 0.0)) return std::nullopt;
    return probe_dragged(frame, pane, world_from_object, glm::dvec2(pane.rect.origin) + glm::dvec2(at) + by);
}

std::optional<Highlight> highlight_at(const Frame& frame, glm::dvec2 pixel, double reach) {
    const Pane* pane = pane_at(frame, pixel);
    if (!pane) return std::nullopt;
    std::optional<Highlight> found;
    double nearest = reach;
    for (const SymbolArrow& arrow : pane->symbols) {
        if (arrow.what.symbol == Symbol::M3)
            continue;  // lies across the whole picture, and is drawn only when pointed at
        const glm::dvec3 from = pane->view.pixel({arrow.base}), to = pane->view.pixel({arrow.base + arrow.vector});
        if (from.z <= 0.0 || to.z <= 0.0) continue;
        const double distance = to_segment(pixel - glm::dvec2(pane->rect.origin), from, to).distance;
        if (distance > nearest) continue;
        nearest = distance;
        found = arrow.what;
    }
    return found;
}

WorldBall bounding_ball(const Mesh& mesh, const Transform<World, Object>& world_from_object) {
    if (mesh.positions.empty()) return {};
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const glm::dvec3& p : mesh.positions) {
        if (!world_from_object.reaches({p})) continue;
        const glm::dvec3 world = world_from_object(Point<Object>{p}).xyz;
        low = glm::min(low, world);
        high = glm::max(high, world);
    }
    if (!(low.x <= high.x)) return {};
    WorldBall ball{{0.5 * (low + high)}, 0.0};
    for (const glm::dvec3& p : mesh.positions)
        if (world_from_object.reaches({p}))
            ball.radius = std::max(ball.radius, glm::length(world_from_object(Point<Object>{p}).xyz - ball.centre.xyz));
    return ball;
}

}  // namespace normalscope

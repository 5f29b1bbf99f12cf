#include "core/picture/pinned_marks.h"

#include "core/frame/solids.h"
#include "core/surface/surface_probe.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <string>

namespace normalscope {

std::vector<std::optional<ProbeInWorld>> pinned_probes(const Scene& scene, const Surface& surface,
                                                       const Transform<World, Object>& world_from_object,
                                                       double right_power, const FlatCut* cut) {
    std::vector<std::optional<ProbeInWorld>> pinned;
    for (const Point<Object>& point : scene.pinned) {
        const std::optional<Probe> probe =
            cut ? nearest_on_cut(surface, *cut, point, scene.borrow) : nearest_probe(surface, point, scene.borrow);
        const bool there = probe && world_from_object.reaches(probe->point);
        pinned.push_back(there ? std::optional(in_world(*probe, world_from_object, scene, right_power)) : std::nullopt);
    }
    return pinned;
}

void add_pinned_marks(Pane& pane, const Scene& scene, const Frame& frame, const FrameOptions& options) {
    const auto& pinned = frame.pinned;
    const bool solid = frame.surface->mesh.closed;
    const glm::vec3 ink = theme_colors(scene.theme).text;
    for (std::size_t i = 0; i < pinned.size(); ++i) {
        if (!pinned[i]) continue;
        const glm::dvec3 at = pinned[i]->point.xyz;
        add_ball(pane.solids, at, 4.5 * options.pixel_scale * pane.view.world_per_pixel({at}), glm::vec4(ink, 1.0f));
        // Of a dot behind a solid nothing is seen, and its number would seem to be in front.
        const auto& outward = pinned[i]->truth;
        const bool behind = solid && outward && glm::dot(outward->xyz, pane.view.eye().xyz - at) < 0.0;
        if (!behind) pane.wanted.push_back({at, std::to_string(i + 1), ink});
    }
}

}  // namespace normalscope

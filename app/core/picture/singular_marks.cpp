#include "core/picture/singular_marks.h"

#include "core/frame/frame_options.h"
#include "core/frame/solids.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace normalscope {

namespace {

constexpr double kApart = 0.978;  ///< cosine of 12°: how far the fan's arrows stand apart at least

// So many of the normals that no two crowd each other.
std::vector<glm::dvec3> thinned(const std::vector<std::vector<glm::dvec3>>& curves) {
    std::vector<glm::dvec3> kept;
    for (const auto& curve : curves)
        for (const glm::dvec3& n : curve)
            if (std::ranges::none_of(kept, [&](const glm::dvec3& k) { return glm::dot(k, n) > kApart; }))
                kept.push_back(n);
    return kept;
}

}  // namespace

bool add_singular_marks(Pane& pane, const Scene& scene, const SingularPoint& singular,
                        const Transform<World, Object>& world_from_object, const FrameOptions& options) {
    if (!scene.show.probe) return false;
    const Point<World> at = world_from_object(singular.at);
    const double pixel = options.pixel_scale * pane.view.world_per_pixel(at);
    const double length = 0.8 * std::max(4.6 * options.unit * scene.arrows.length, 70.0 * pixel);
    const glm::vec3 ink = theme_colors(scene.theme).text, color = rule_color(pane.rule);
    std::size_t arrows = 0;
    std::optional<glm::dvec3> lent;  // the tip of the normal that is borrowed

    if (const auto map = normal_map(scene, world_from_object, pane.rule)) {
        std::vector<std::vector<glm::dvec3>> fan;
        for (const auto& curve : singular.fan) {
            fan.emplace_back();
            for (const Normal<Object>& n : curve)
                if (const glm::dvec3 world = (*map)(n).xyz; glm::length(world) > 0.0)
                    fan.back().push_back(glm::normalize(world));
        }
        for (const auto& curve : fan)
            for (std::size_t i = 0; i + 1 < curve.size(); ++i)
                for (const glm::dvec3& corner : {glm::dvec3(0.0), curve[i], curve[i + 1]})
                    pane.translucent.push_back(
                        {glm::vec3(at.xyz + 0.9 * length * corner), glm::vec3(0.0f), glm::vec4(color, 0.22f)});
        const double radius = std::max(0.010 * options.unit, 1.25 * pixel);
        for (const glm::dvec3& n : thinned(fan)) {
            ++arrows;
            add_arrow(pane.solids, at.xyz, length * n, radius, glm::vec4(color, 1.0f));
            pane.strokes.push_back({at.xyz, at.xyz + length * n, ArrowProportions::kHeadRadius * radius});
        }
        if (singular.lender) {
            const Point<World> from = world_from_object(singular.lender->point);
            add_tube(pane.solids, std::array{at.xyz, from.xyz}, std::max(0.008 * options.unit, 1.2 * pixel),
                     glm::vec4(ink, 1.0f));
            add_ball(pane.solids, from.xyz, 3.6 * pixel, glm::vec4(ink, 1.0f));
            if (const glm::dvec3 n = (*map)(singular.lender->normal).xyz; glm::length(n) > 0.0) {
                // Longer than the fan's, which it would be lost among.
                lent = from.xyz + 1.35 * length * glm::normalize(n);
                add_arrow(pane.solids, from.xyz, *lent - from.xyz, 2.0 * radius, glm::vec4(color, 1.0f));
                pane.strokes.push_back({from.xyz, *lent, 2.0 * ArrowProportions::kHeadRadius * radius});
            }
        }
    }
    add_ball(pane.solids, at.xyz, 4.2 * pixel, glm::vec4(ink, 1.0f));
    const glm::dvec3 beside = at.xyz + (1.05 * length) * pane.view.right().xyz;
    if (lent) pane.wanted.push_back({*lent, "borrowed normal", color});
    pane.wanted.push_back(
        {beside, singular.undefined ? "no normal here: \u2207f does not exist" : "no normal here: \u2207f = 0", ink});
    return arrows > 2;
}

}  // namespace normalscope

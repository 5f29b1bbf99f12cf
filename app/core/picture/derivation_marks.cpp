#include "core/picture/derivation_marks.h"

#include "core/frame/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace normalscope {

namespace {

// A product is what it comes to: M3 v_obj is v_world.
Symbol symbol_of(const CarriedArrow& arrow) {
    if (arrow.meaning == Meaning::Object) return Symbol::NObject;
    if (arrow.meaning != Meaning::Tangent) return Symbol::NWorld;
    return arrow.name == "v object" ? Symbol::VObject : Symbol::VWorld;
}

}  // namespace

void add_derivation_marks(Pane& pane, const Scene& scene, const ProbeInWorld& probe,
                          const Transform<World, Object>& world_from_object, const FrameOptions& options) {
    const CarriedArrows shown = carried_arrows(*options.marks.line, probe, world_from_object);
    const double pixel = options.pixel_scale * pane.view.world_per_pixel(probe.point);
    const double unit = std::max(4.6 * options.unit * scene.arrows.length, 70.0 * pixel);  // as the probe's own
    const double radius = std::max(0.022 * unit, 1.7 * pixel);
    // What M makes very long or short is still an arrow in the picture.
    const auto drawn = [&](const CarriedArrow& arrow) {
        const double length = arrow.to_scale ? 0.0 : glm::length(arrow.vector);
        return length > 0.0 ? unit * std::clamp(length, 0.35, 2.2) / length * arrow.vector : arrow.vector;
    };
    const auto& stands_out = options.marks.highlight;
    const auto color_of = [&](const CarriedArrow& arrow) {
        const glm::vec3 color = arrow.meaning == Meaning::Object    ? arrow_color(ArrowKind::Object, scene.theme)
                                : arrow.meaning == Meaning::Tangent ? kTangentColor
                                                                    : kInverseTransposeColor;
        return stands_out && symbol_of(arrow) != stands_out->symbol ? muted(color, scene.theme) : color;
    };
    const auto add = [&](const CarriedArrow& arrow, double wide) {
        const glm::vec4 color = glm::vec4(color_of(arrow), 1.0f);
        if (arrow.quiet)
            add_tube(pane.solids, std::array{arrow.base, arrow.base + drawn(arrow)}, 0.6 * pixel, color);
        else
            add_arrow(pane.solids, arrow.base, drawn(arrow), wide * radius, color);
        pane.strokes.push_back(
            {arrow.base, arrow.base + drawn(arrow), arrow.quiet ? 0.0 : ArrowProportions::kHeadRadius * wide * radius});
    };
    for (std::size_t i = 0; i < shown.arrows.size(); ++i) {
        // Where one comes to lie on another both are seen: the later one goes around it, and ends a little before its tip.
        const bool around = options.marks.line->line == DerivationLine::SameDirection && i == 1;
        CarriedArrow arrow = shown.arrows[i];
        if (around) arrow.vector *= 0.72;
        add(arrow, around ? 1.5 : 1.0);
    }
    for (const glm::dvec3& at : {probe.object.point.xyz, probe.point.xyz})
        add_ball(pane.solids, at, 1.6 * radius, glm::vec4(theme_colors(scene.theme).text, 1.0f));
    if (shown.right_angle) {
        // At the first of them, the normal: an edge of H may stand somewhere else.
        const CarriedArrow &a = shown.arrows[(*shown.right_angle)[0]], &b = shown.arrows[(*shown.right_angle)[1]];
        const double side = 0.2 * unit;
        const glm::dvec3 u = side * glm::normalize(a.vector), v = side * glm::normalize(b.vector);
        const std::array corner{a.base + u, a.base + u + v, a.base + v};
        add_tube(pane.solids, corner, 1.2 * pixel, glm::vec4(theme_colors(scene.theme).text, 1.0f));
        keep_clear(pane, corner);
    }
    for (const CarriedArrow& arrow : shown.arrows) {
        const bool lies_on = options.marks.line->line == DerivationLine::SameDirection;
        const bool first = &arrow == shown.arrows.data();
        pane.wanted.push_back(
            {arrow.base + (lies_on && !first ? 0.5 : 1.0) * drawn(arrow), arrow.name, color_of(arrow)});
    }
}

}  // namespace normalscope

#include "core/picture/handle_marks.h"

#include "core/frame/axis_handles.h"
#include "core/frame/knobs.h"
#include "core/frame/solids.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <string>

namespace normalscope {

void add_axes(Pane& pane, const Scene& scene, const glm::dvec3& extent, const FrameOptions& options) {
    for (const AxisHandle& handle : axis_handles(scene, extent)) {
        const glm::vec3 color = kAxisColors[static_cast<std::size_t>(handle.axis)];
        const bool hot = options.hot_axis == handle.axis;
        const double thickness =
            std::max(0.010 * options.unit, 1.4 * options.pixel_scale * pane.view.world_per_pixel(handle.origin));
        const glm::dvec3 knob = handle.knob().xyz;
        add_tube(pane.solids, std::array{handle.origin.xyz, knob}, thickness, glm::vec4(color, 1.0f));
        pane.strokes.push_back({handle.origin.xyz, knob, thickness});
        const double half = (hot ? 8.5 : 6.5) * options.pixel_scale * pane.view.world_per_pixel(handle.knob());
        if (options.handles)
            add_cube(pane.solids, knob, handle.unit.xyz, half,
                     glm::vec4(hot ? glm::mix(color, glm::vec3(1.0f), 0.35f) : color, 1.0f));
        const double sense = handle.factor < 0.0 ? -1.0 : 1.0;
        pane.wanted.push_back({.at = knob + sense * 2.6 * half * glm::normalize(handle.unit.xyz),
                               .text = std::string(1, "xyz"[handle.axis]),
                               .color = color,
                               .there = true});
    }
}

void add_knobs(Pane& pane, const Scene& scene, const Transform<World, Object>& m, const FrameOptions& options) {
    const glm::vec4 ink(theme_colors(scene.theme).text, 1.0f);
    for (const Knob& knob : knobs(scene, m, pane.view)) {
        const double pixel = options.pixel_scale * pane.view.world_per_pixel(knob.at);
        if (knob.what != Knob::What::Slice) {
            add_cube(pane.solids, knob.at.xyz, pane.view.up().xyz, 6.0 * pixel, ink);
            continue;
        }
        const glm::dvec3 along = glm::normalize(knob.along.xyz);
        add_cube(pane.solids, knob.at.xyz, along, 6.5 * pixel, ink);
        for (const double side : {-1.0, 1.0})
            add_arrow(pane.solids, knob.at.xyz, side * 26.0 * pixel * along, 1.6 * pixel, ink);
    }
}

}  // namespace normalscope

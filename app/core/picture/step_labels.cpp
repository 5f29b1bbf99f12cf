#include "core/picture/step_labels.h"

#include "core/base/overload.h"

namespace normalscope {

void add_step_labels(Pane& pane, const Scene& scene, const Transform<World, Object>& world_from_object,
                     const FrameOptions& options) {
    for (const PointLabel& label : options.marks.labels) {
        const auto at = std::visit(
            Overload{[](const Point<World>& p) { return std::optional(p); },
                     [&](const Point<Object>& p) {
                         return world_from_object.reaches(p) ? std::optional(world_from_object(p)) : std::nullopt;
                     }},
            label.at);
        if (at) pane.wanted.push_back({at->xyz, label.text, theme_colors(scene.theme).text});
    }
}

}  // namespace normalscope

#include "core/picture/framing.h"

#include "core/frame/axis_handles.h"
#include "core/frame/picture_scale.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

double framing_zoom(const Scene& scene, const Surface& surface) {
    constexpr double kMargin = 1.08;  // words stand about it
    const Transform<World, Object> m = world_from_object(scene);
    const std::vector<glm::dvec3>& positions = surface.mesh.positions;
    if (positions.empty() || !m.affine()) return 1.0;

    const bool ghost = scene.show.ghost && (scene.view == ViewMode::Overlay || scene.view == ViewMode::Flat);
    double object = 0.0, untransformed = 0.0;
    const std::size_t step = 1 + positions.size() / 20000;
    for (std::size_t i = 0; i < positions.size(); i += step) {
        const Point<Object> p{positions[i]};
        object = std::max(object, glm::distance(m(p).xyz, scene.camera.target.xyz));
        if (ghost) untransformed = std::max(untransformed, glm::distance(p.xyz, scene.camera.target.xyz));
    }
    const double arrow = scene.arrows.limit > 0 ? 2.0 * scene.arrows.length : 0.0;
    double radius = std::max(object + arrow * picture_unit(surface, m), ghost ? untransformed + arrow : 0.0);
    if (scene.show.axes)
        for (const AxisHandle& handle : axis_handles(scene, surface.extent))
            radius = std::max(radius, glm::distance(handle.knob().xyz, scene.camera.target.xyz));
    if (scene.show.stretch_axes) radius = std::max(radius, 1.3 * m.normal_matrices_by_rule().sigma.x);
    return framed(scene.camera, scene.camera.target, kMargin * radius).magnification();
}

Scene with_zoom(Scene scene, const Surface& surface) {
    if (scene.camera.zoom) return scene;
    Scene whole = scene;
    whole.stack_position.reset();  // while the stack is played, the camera waits for what comes of it
    scene.camera.zoom = framing_zoom(whole, surface);
    return scene;
}

}  // namespace normalscope

#include "viewer/surface_in_time.h"

#include <chrono>
#include <utility>
#include <variant>

using namespace std::chrono_literals;

namespace normalscope {

void SurfaceInTime::take(std::unique_ptr<SurfaceCache> surfaces) {
    stop_making();
    surfaces_ = std::move(surfaces);
}

// On a copy, which shares all that is there: the one before stays good.
void SurfaceInTime::begin(const Scene& scene) {
    made_from_ = scene.surface;
    stop_making();
    making_ = beside([scene, surfaces = std::make_unique<SurfaceCache>(*surfaces_)](const Stop& stop) mutable {
        surfaces->get(scene, stop);
        return std::move(surfaces);
    });
}

SurfaceInTime::Shown SurfaceInTime::get(const Scene& scene) {
    const bool at_once =
        surfaces_->empty() || surfaces_->has_mesh_of(scene) || !std::holds_alternative<FormulaSurface>(scene.surface);
    if (at_once) {
        stop_making();
        return {scene, surfaces_->get(scene)};
    }
    const bool is_new = !making_ || made_from_ != scene.surface;
    if (is_new) begin(scene);
    if (making_.ready(is_new ? 100ms : 0ms)) {
        surfaces_ = making_.get();
        return {scene, surfaces_->get(scene)};
    }
    Shown before{.scene = scene};
    before.scene.surface = surfaces_->source();
    before.surface = surfaces_->get(before.scene);
    return before;
}

std::shared_ptr<const Surface> SurfaceInTime::get_now(const Scene& scene) {
    if (making_ && made_from_ == scene.surface) surfaces_ = making_.get();
    return surfaces_->get(scene);
}

}  // namespace normalscope

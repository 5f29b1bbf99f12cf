// What a large mesh costs while one turns it: mesh_bench MESH. Prints one line of JSON: milliseconds, medians.

#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/picture/picking.h"
#include "core/scene/scene_json.h"
#include "core/surface/surface_probe.h"
#include "measure.h"

#include <cstdio>
#include <vector>

using namespace normalscope;

namespace {

struct Turning {
    std::vector<double> frame, probe, click, by_all;

    void turn(Scene& scene, const std::shared_ptr<const Surface>& surface, int frames) {
        const PixelRect rect{{0, 0}, {1280, 720}};
        const Transform<World, Object> m = world_from_object(scene);
        for (int i = 0; i < frames; ++i) {
            scene.camera.azimuth += 7.0;
            const Stopwatch making;
            const Frame all = make_frame(scene, surface, {.rect = rect});
            frame.push_back(making.milliseconds());
            const Stopwatch probing;
            probe_in_view(*surface, m, all.panes.front().view, {640.0, 360.0});
            probe.push_back(probing.milliseconds());
            const Stopwatch clicking;
            picked_point(all, m, {500.0 + i, 300.0}, 8.0);
            click.push_back(clicking.milliseconds());
            if (i % 10 != 0) continue;
            const Stopwatch looking_at_all;
            probe_in_view(surface->mesh, m, all.panes.front().view, {640.0, 360.0});
            by_all.push_back(looking_at_all.milliseconds());
        }
    }
};

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    Scene scene = load_scene(std::string(kDefaultScene));
    scene.surface = MeshSurface{arguments[1]};
    SurfaceCache surfaces;
    const Stopwatch reading;
    const auto surface = surfaces.get(scene);
    const double read_ms = reading.milliseconds();
    const Stopwatch planting;
    if (surface->tree) surface->tree->for_many(surface->mesh);
    const double tree_ms = planting.milliseconds();
    Turning turning;
    turning.turn(scene, surface, 52);
    std::printf(
        "{\"triangles\": %zu, \"read_ms\": %.1f, \"tree_ms\": %.1f, \"frame_ms\": %.3f, \"probe_ms\": %.4f, "
        "\"click_ms\": %.4f, \"probe_by_all_ms\": %.1f}\n",
        surface->mesh.triangles.size(), read_ms, tree_ms, median(turning.frame), median(turning.probe),
        median(turning.click), median(turning.by_all));
}

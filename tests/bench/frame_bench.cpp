// What one interactive frame costs: the default scene with its panel, the camera turning, drawn off-screen as the
// window draws it. Prints one line of JSON: frames a second, from the median, by samples a pixel. `frame_bench arrows` is the
// same of a finely divided torus with more and more arrows, each count by samples.

#include "bench_gui.h"
#include "core/frame/frame.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/scene/scene_json.h"
#include "core/scene/setting.h"
#include "core/surface/surface.h"
#include "gl/version.h"
#include "measure.h"
#include "platform/offscreen_context.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace normalscope;

namespace {

/// Per second.
double frames(Scene scene, int samples, int pictures) {
    constexpr glm::ivec2 kSize(1280, 720);
    BenchGui gui(kSize);
    SurfaceCache surfaces;
    std::vector<double> milliseconds;
    for (int i = 0; i < pictures + 5; ++i) {
        const Stopwatch watch;
        scene.camera.azimuth += 1.0;
        const Frame frame = make_frame(scene, surfaces.get(scene), {.rect = gui.interface().picture(kSize)});
        gui.layout(scene.theme, 1.0f, [&] { gui.interface().draw(scene, frame, {}); });
        gui.draw({.frame = frame, .rough = samples == 1, .timed = true});
        if (i >= 5) milliseconds.push_back(watch.milliseconds());  // the first ones compile shaders
    }
    return 1000.0 / median(milliseconds);
}

/// One at each vertex.
Scene with_arrows(int resolution) {
    Scene scene;
    for (const std::string& set : {std::string("surface.shape=torus"),
                                   "surface.resolution=" + std::to_string(resolution), std::string("view=single")})
        scene = with_setting(scene, set);
    scene.arrows = {.length = 0.05, .limit = 1'000'000, .show = std::vector{ArrowKind::InverseTranspose}};
    return scene;
}

}  // namespace

int main(int count, char** words) {
    const auto context = make_offscreen_context({});
    context->make_current();
    if (count == 4) {  // for `where`: so many pictures with so many samples
        (void)frames(load_scene(std::string(kDefaultScene)), std::atoi(words[2]), std::atoi(words[3]));
        return 0;
    }
    std::printf("{\"renderer\": \"%s\"", renderer_name().c_str());
    const auto print = [](const std::string& what, const Scene& scene, int pictures) {
        std::printf(", \"%s\": {\"1\": %.1f, \"4\": %.1f}", what.c_str(), frames(scene, 1, pictures),
                    frames(scene, 4, pictures));
    };
    if (count == 1)
        print("frames_per_second", load_scene(std::string(kDefaultScene)), 60);
    else
        for (const int resolution : {46, 92, 180, 198, 200, 448}) {
            const Scene scene = with_arrows(resolution);
            print(std::to_string(SurfaceCache().get(scene)->arrows.size()), scene, 10);
        }
    std::printf("}\n");
}

// What one interactive frame costs: the default scene with its panel, the camera turning, drawn off-screen as the
// window draws it. Prints one line of JSON: frames a second, from the median, by samples a pixel.

#include "bench_gui.h"
#include "core/frame/frame.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/scene/scene_json.h"
#include "core/surface/surface.h"
#include "gl/version.h"
#include "measure.h"
#include "platform/offscreen_context.h"

#include <cstdio>
#include <vector>

using namespace normalscope;

namespace {

double median_frame_milliseconds(int samples) {
    constexpr glm::ivec2 kSize(1280, 720);
    constexpr int kFrames = 60;
    BenchGui gui(kSize);
    SurfaceCache surfaces;
    Scene scene = load_scene(std::string(kDefaultScene));
    std::vector<double> milliseconds;
    for (int i = 0; i < kFrames + 5; ++i) {
        const Stopwatch watch;
        scene.camera.azimuth += 1.0;
        const Frame frame = make_frame(scene, surfaces.get(scene), {.rect = gui.interface().picture(kSize)});
        gui.layout(scene.theme, 1.0f, [&] { gui.interface().draw(scene, frame, {}); });
        gui.draw({.frame = frame, .rough = samples == 1, .timed = true});
        if (i >= 5) milliseconds.push_back(watch.milliseconds());  // the first ones compile shaders
    }
    return median(milliseconds);
}

}  // namespace

int main() {
    const auto context = make_offscreen_context({});
    context->make_current();
    std::printf("{\"renderer\": \"%s\", \"frames_per_second\": {\"1\": %.1f, \"4\": %.1f}}\n", renderer_name().c_str(),
                1000.0 / median_frame_milliseconds(1), 1000.0 / median_frame_milliseconds(4));
}

// From the second picture on, sky, ground and what stands before them are drawn by programs of their own.

#include "support.h"

#include "core/frame/frame.h"
#include "core/picture/ground.h"
#include "core/picture/make_frame.h"
#include "core/scene/setting.h"
#include "core/surface/surface.h"
#include "gl/renderer.h"
#include "gl/target.h"

#include <string>
#include <vector>

namespace normalscope {
namespace {

constexpr glm::ivec2 kSize(320, 180);

Frame frame_of(const std::vector<std::string>& settings) {
    Scene scene;
    for (const std::string& set : settings) scene = with_setting(scene, set);
    return make_frame(scene, SurfaceCache().get(scene), {.rect = {{0, 0}, kSize}});
}

TEST(Backdrop, IsTheSameInPartsAsInOne) {
    need_context();
    const std::vector<std::vector<std::string>> scenes{
        {},
        {"view=split"},
        {"view=single", "camera.elevation=2"},
        {"view=single", "camera.elevation=-35"},
        {"view=single", "camera.elevation=89", "camera.zoom=0.3"},
        {"view=single", "camera.zoom=8", "camera.elevation=10"},
        {"view=single", "camera.zoom=0.05"},
        {"view=single", "stack=[{\"scale\": [9, 0.2, 9]}]", "theme=dark"},
        {"view=single", "stack=[{\"translate\": [30, 0, 0]}]"},
        {"view=single", "show.grid=false"},
        {"view=single", "surface={\"formula\": \"x^2 + y^2 + z^2 - 1\"}"},
    };
    int smaller = 0;
    for (const auto& settings : scenes)
        for (const int samples : {1, 4}) {
            const Frame frame = frame_of(settings);
            Target target(kSize, samples);
            Renderer renderer;
            renderer.draw(frame, target);
            const Image once = target.read();
            renderer.draw(frame, target);
            EXPECT_TRUE(target.read().rgba == once.rgba)
                << samples << " samples, " << (settings.empty() ? "as it begins" : settings.back());
            const PixelRect ground = ground_box(frame, frame.panes.front());
            smaller += ground.size.x * ground.size.y < kSize.x * kSize.y * 9 / 10 ? 1 : 0;
        }
    EXPECT_GT(smaller, 8);
}

}  // namespace
}  // namespace normalscope

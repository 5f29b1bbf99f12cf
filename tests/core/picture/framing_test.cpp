#include "core/picture/framing.h"

#include "core/frame/label_room.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/scene/setting.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace normalscope;

namespace {

constexpr glm::ivec2 kSize{640, 480};

// How far the object's points come out from the middle of the picture, as a share of the way to its nearer edge.
double reach(const Scene& scene) {
    SurfaceCache surfaces;
    const auto surface = surfaces.get(scene);
    const Frame frame = make_frame(scene, surface, {.rect = {{0, 0}, kSize}});
    const Transform<World, Object> m = world_from_object(scene);
    double most = 0.0;
    for (const glm::dvec3& p : surface->mesh.positions) {
        const glm::dvec2 from_middle =
            glm::abs(glm::dvec2(frame.panes[0].view.pixel(m(Point<Object>{p}))) - 0.5 * glm::dvec2(kSize));
        most = std::max({most, from_middle.x, from_middle.y});
    }
    return most / (0.5 * kSize.y);
}

bool lies_on(const glm::dvec2& middle, const glm::dvec2& half, const glm::dvec2& a, const glm::dvec2& b) {
    for (int k = 0; k <= 100; ++k)
        if (glm::all(glm::lessThan(glm::abs(glm::mix(a, b, 0.01 * k) - middle), half))) return true;
    return false;
}

TEST(Framing, WhateverTheSizeOfTheObjectItFillsThePicture) {
    for (const char* setting :
         {"stack=[]", R"(stack=[{"scale":[0.5,2,1]}])", R"(stack=[{"scale":[50,20,70]}])",
          R"(stack=[{"scale":[0.01,0.02,0.01]}])", R"(surface={"formula":"x^2+y^2-z^2-30","bound":10})",
          R"(surface={"formula":"x^2+y^2+z^2-0.1","bound":0.5})"}) {
        const Scene scene = with_setting(Scene{.show = {.ghost = false, .axes = false}}, setting);
        EXPECT_GT(reach(scene), 0.5) << setting;
        EXPECT_LT(reach(scene), 1.0) << setting;
    }
}

TEST(Framing, AZoomThatIsSaidStays) {
    const Scene scene{.camera = {.zoom = 0.3}};
    SurfaceCache surfaces;
    EXPECT_EQ(with_zoom(scene, *surfaces.get(scene)), scene);
}

TEST(Framing, WhatIsNotAffineIsLeftAsItIs) {
    const Scene scene{.stack = {Matrix{{{1, 0, 0, 0.5}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}}};
    SurfaceCache surfaces;
    EXPECT_EQ(framing_zoom(scene, *surfaces.get(scene)), 1.0);
}

// The first thing that one reads must not hide the first thing that one looks at.
TEST(Framing, NoWordsLieOnTheProbesArrows) {
    SurfaceCache surfaces;
    for (const BuiltInScene& built_in : built_in_scenes()) {
        const Scene scene = load_scene(built_in.name);
        if (scene.ray) continue;  // which has marks of its own
        for (const auto& [size, scale] :
             {std::pair{glm::ivec2(1280, 720), 1.0f}, std::pair{glm::ivec2(1920, 1080), 1.5f},
              std::pair{glm::ivec2(3840, 2160), 3.0f}, std::pair{glm::ivec2(390, 844), 1.0f}}) {
            Frame frame = make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, size}, .pixel_scale = scale});
            if (!frame.probe) continue;
            for (Pane& pane : frame.panes) {
                const LabelRoom room(pane, static_cast<double>(scale));
                for (const Label& label : pane.labels) {
                    if (!label.text.ends_with(" off") && !label.text.ends_with(" surface")) continue;
                    const glm::dvec2 middle = glm::dvec2(label.pixel) - glm::dvec2(pane.rect.origin),
                                     half = room.half_size(label.text, label.role);
                    for (const Stroke& stroke : pane.strokes)
                        if (stroke.a == frame.probe->point.xyz) {
                            EXPECT_FALSE(lies_on(middle, half, glm::dvec2(pane.view.pixel({stroke.a})),
                                                 glm::dvec2(pane.view.pixel({stroke.b}))))
                                << built_in.name << " at " << size.x << ": " << label.text;
                        }
                }
            }
        }
    }
}

}  // namespace

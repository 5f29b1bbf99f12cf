#include "core/picture/drawn_box.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/scene/setting.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace normalscope {
namespace {

Frame frame_of(Scene scene, const std::string& setting) {
    SurfaceCache surfaces;
    scene = with_setting(scene, setting);
    return make_frame(scene, surfaces.get(scene), {.rect = {{100, 50}, {800, 600}}});
}

// What lies outside of the box is not drawn: an arrow's tip there would be cut off without a word.
TEST(DrawnBox, HoldsSurfaceAndArrows) {
    for (const BuiltInScene& built_in : built_in_scenes())
        for (const char* setting :
             {"camera.azimuth=-70", "camera.target=[0.5,1,0]", "camera.zoom=4", "arrows.length=1"}) {
            const Frame frame = frame_of(load_scene(std::string(built_in.name)), setting);
            for (const Pane& pane : frame.panes) {
                const PixelRect box = drawn_box(*frame.surface, pane);
                const auto expect_inside = [&](const glm::dvec3& world) {
                    const glm::dvec3 in_pane = pane.view.pixel({world});
                    const glm::dvec2 pixel = glm::dvec2(in_pane) + glm::dvec2(pane.rect.origin);
                    const bool seen = in_pane.z > 0.0 && pane.rect.origin.x <= pixel.x &&
                                      pane.rect.origin.y <= pixel.y &&
                                      pixel.x < pane.rect.origin.x + pane.rect.size.x &&
                                      pixel.y < pane.rect.origin.y + pane.rect.size.y;
                    if (!seen) return;
                    EXPECT_GE(pixel.x, box.origin.x) << built_in.name << " " << setting;
                    EXPECT_GE(pixel.y, box.origin.y) << built_in.name << " " << setting;
                    EXPECT_LE(pixel.x, box.origin.x + box.size.x) << built_in.name << " " << setting;
                    EXPECT_LE(pixel.y, box.origin.y + box.size.y) << built_in.name << " " << setting;
                };
                for (const SurfaceDraw& draw : pane.surfaces)
                    for (const glm::dvec3& p : frame.surface->mesh.positions) {
                        const glm::dvec4 world = glm::dmat4(draw.world_from_object) * glm::dvec4(p, 1.0);
                        expect_inside(glm::dvec3(world) / world.w);
                    }
                for (const ArrowDraw& draw : pane.arrows)
                    for (const Site& site : frame.surface->arrows) {
                        const glm::dvec4 base = glm::dmat4(draw.world_from_object) * glm::dvec4(site.point.xyz, 1.0);
                        const glm::dvec3 direction = draw.normals(site.normal).xyz;
                        if (glm::length(direction) > 0.0)
                            expect_inside(glm::dvec3(base) / base.w + double(draw.length) * glm::normalize(direction));
                    }
                EXPECT_LT(box.size.x * box.size.y, 800 * 600 + 1);
            }
        }
}

TEST(DrawnBox, IsTheWholePaneBehindTheEye) {
    const Frame frame = frame_of(load_scene("slide-scale"), "camera.zoom=200");
    EXPECT_EQ(drawn_box(*frame.surface, frame.panes[0]), frame.panes[0].rect);
}

TEST(DrawnBox, UnitesWithNothing) {
    const PixelRect some{{3, 4}, {5, 6}};
    EXPECT_EQ(united({}, some), some);
    EXPECT_EQ(united(some, {}), some);
    EXPECT_EQ(united(some, {{0, 9}, {4, 2}}), (PixelRect{{0, 4}, {8, 7}}));
}

}  // namespace
}  // namespace normalscope

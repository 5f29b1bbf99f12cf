#include "core/frame/knobs.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace normalscope {
namespace {

TEST(Knobs, TheRaysEndsFollowThePointer) {
    Scene scene;
    scene.ray = AimedRay{Point<World>{{-1.0, 1.0, 1.5}}, Point<World>{{0.25, 0.0, 0.5}}, 3};
    const CameraView view(scene.camera, {640, 480});
    const auto all = knobs(scene, {}, view);
    ASSERT_EQ(all.size(), 2u);
    const glm::dvec2 at(view.pixel(all[0].at)), to = at + glm::dvec2(40.0, -25.0);
    const auto grabbed = knob_at(all, view, at + glm::dvec2(3.0, 2.0), 11.0);
    ASSERT_TRUE(grabbed && grabbed->what == Knob::What::RayFrom);
    EXPECT_FALSE(knob_at(all, view, at + glm::dvec2(30.0, 0.0), 11.0));
    const Scene moved = dragged(scene, *grabbed, view, to);
    // In hundredths of a unit, which are less than two pixels here.
    EXPECT_LT(glm::distance(glm::dvec2(view.pixel(*moved.ray->from)), to), 2.0);
    EXPECT_EQ(moved.ray->toward, scene.ray->toward);
    EXPECT_EQ(moved.ray->step, 3);
}

TEST(Knobs, TheSliceMovesAlongItsAxisWhereverMTakesThat) {
    Scene scene;
    scene.surface = FormulaSurface{};
    scene.slice = Slice{.axis = Axis::X, .at = 0.5};
    scene.stack = {Scale{{2.0, 1.0, 1.0}}, Rotate{{0.0, 0.0, 1.0}, 90.0}};
    scene.camera = {.azimuth = 0.0, .elevation = 0.0};
    const Transform<World, Object> m = world_from_object(scene);
    const CameraView view(scene.camera, {640, 480});
    const auto all = knobs(scene, m, view);
    ASSERT_EQ(all.size(), 1u);
    // The object's x has become the world's y, twice as long.
    const Scene moved =
        dragged(scene, all[0], view, glm::dvec2(view.pixel(all[0].at + Vector<World>{{0.0, 1.0, 0.0}})));
    EXPECT_NEAR(moved.slice->at, 1.0, 1e-9);
    // Not out of the ball, and not by a shape.
    EXPECT_EQ(dragged(scene, all[0], view, {320.0, -3000.0}).slice->at, 2.0);
    scene.surface = ShapeSurface{};
    EXPECT_TRUE(knobs(scene, m, view).empty());
}

}  // namespace
}  // namespace normalscope

// The mouse in the picture: the knobs, the camera, the light, the probe.

#include "viewer/hosted.h"

#include <algorithm>
#include <cmath>

namespace normalscope {
namespace {

class MouseTest : public ViewerTest {
protected:
    /// Where an axis' knob stands for that factor, at a sphere.
    glm::dvec2 knob(int axis, double factor) const {
        glm::dvec3 at(0.0);
        at[axis] = 1.15 * factor;
        return pixel(at);
    }
    const Scale& scale() const { return std::get<Scale>(scene().stack.at(0)); }
    Scene with_factor(Scene before, int axis, double factor) const {
        std::get<Scale>(before.stack.at(0)).factors[axis] = factor;
        return before;
    }
    /// On the sphere, toward the camera.
    const glm::dvec3 toward_us_{std::sin(0.9) * std::cos(0.5), std::sin(0.5), std::cos(0.9) * std::cos(0.5)};
};

TEST_F(MouseTest, AKnobStretchesItsAxis) {
    start();
    const Scene before = scene();
    drag({knob(2, 1), knob(2, 1.3), knob(2, 1.6)});
    const double factor = scale().factors.z;
    EXPECT_NEAR(factor, 1.6, 0.03);
    EXPECT_NEAR(factor, std::round(factor * 100) / 100, 1e-9);
    EXPECT_EQ(scene(), with_factor(before, 2, factor));
    expect_undo({before, scene()});
}

TEST_F(MouseTest, AKnobThroughZeroMirrors) {
    start();
    const Scene before = scene();
    drag({knob(0, 0.5), knob(0, 0.2), knob(0, 0), knob(0, -0.2), knob(0, -0.5)});
    EXPECT_NEAR(scale().factors.x, -0.5, 0.05);
    EXPECT_EQ(scene(), with_factor(before, 0, scale().factors.x));
    expect_undo({before, scene()});
}

TEST_F(MouseTest, ShiftAndAKnobScaleEvenly) {
    start(light("identity"));
    drag({knob(1, 1), knob(1, 1.5)}, 0, ImGuiMod_Shift);
    EXPECT_NEAR(scale().factors.x, 1.5, 0.03);
    EXPECT_EQ(scale().factors, glm::dvec3(scale().factors.x));
}

TEST_F(MouseTest, KnobsAimTheRayAndMoveTheSlice) {
    Scene with_ray = light();
    with_ray.stack = {};
    with_ray.surface = FormulaSurface{.formula = "x^2+y^2+z^2-1"};
    with_ray.ray = AimedRay{.from = Point<World>{{-1.2, 1.2, 0.6}}, .toward = Point<World>{{0, 0.2, 0.4}}};
    with_ray.slice = Slice{.axis = Axis::Y, .at = 0.5};
    start(with_ray);
    drag({pixel({-1.2, 1.2, 0.6}), pixel({-1.2, 0.9, 0.6})});
    ASSERT_TRUE(scene().ray && scene().ray->from);
    EXPECT_LT(glm::length(scene().ray->from->xyz - glm::dvec3(-1.2, 0.9, 0.6)), 0.15);  // seen from above
    Scene aimed = with_ray;
    aimed.ray->from = scene().ray->from;
    EXPECT_EQ(scene(), aimed);
    expect_undo({with_ray, aimed});

    const double edge = 1.06 * std::sqrt(4 - 0.25);
    drag({pixel({edge, 0.5, 0}), pixel({edge, 0.2, 0})});
    EXPECT_NEAR(scene().slice->at, 0.2, 0.03);
}

TEST_F(MouseTest, ADragOrbits) {
    start();
    const Scene before = scene();
    drag({ground(), ground() + glm::dvec2(50, -30)});
    Scene expected = before;
    expected.camera.azimuth = before.camera.azimuth - 20;
    expected.camera.elevation = before.camera.elevation - 12;
    EXPECT_NEAR(scene().camera.azimuth, expected.camera.azimuth, 1e-9);
    EXPECT_NEAR(scene().camera.elevation, expected.camera.elevation, 1e-9);
    expected.camera = scene().camera;
    EXPECT_EQ(scene(), expected);
    expect_undo({before, scene()});
}

TEST_F(MouseTest, TheOtherButtonsPan) {
    start();
    for (const int button : {1, 2}) {
        const Scene before = scene();
        const glm::dvec2 origin = pixel({0, 0, 0});
        drag({ground(), ground() + glm::dvec2(40, -30)}, button);
        EXPECT_LT(glm::length(pixel({0, 0, 0}) - origin - glm::dvec2(40, -30)), 1.0);
        Scene moved = scene();
        moved.camera.target = before.camera.target;
        EXPECT_EQ(moved, before);
        const Scene panned = scene();
        expect_undo({before, panned});
        key(ImGuiMod_Ctrl | ImGuiKey_Y);
        EXPECT_EQ(scene(), panned);
    }
}

TEST_F(MouseTest, TheWheelZoomsAndAPauseInItMakesAStep) {
    start();
    const Scene before = scene();
    point(ground());
    for (int i = 0; i < 3; ++i) wheel(1);
    EXPECT_NEAR(*scene().camera.zoom, before.camera.magnification() * std::pow(1.12, 3), 1e-9);
    const Scene nearer = scene();
    key(ImGuiKey_N);  // an end to it
    for (int i = 0; i < 5; ++i) wheel(-1);
    EXPECT_NEAR(*scene().camera.zoom, before.camera.magnification() * std::pow(1.12, -2), 1e-9);
    Scene naive = nearer;
    naive.rule = Rule::Naive;
    expect_undo({before, nearer, naive, scene()});
}

TEST_F(MouseTest, TheWheelOverHelpZoomsNothing) {
    start();
    key(ImGuiKey_F1);
    point(glm::dvec2(viewer().frame()->rect.origin + viewer().frame()->rect.size / 2));
    const Scene before = scene();
    wheel(1);
    EXPECT_EQ(scene(), before);
}

TEST_F(MouseTest, ShiftAndADragMoveTheLight) {
    start();
    const Scene before = scene();
    drag({ground(), ground() + glm::dvec2(50, -20)}, 0, ImGuiMod_Shift);
    EXPECT_NE(scene().light, before.light);
    Scene lit = before;
    lit.light = scene().light;
    EXPECT_EQ(scene(), lit);
    expect_undo({before, lit});
}

TEST_F(MouseTest, AClickOnTheSurfacePlacesTheProbe) {
    Scene bare = light();
    bare.arrows.show = std::vector<ArrowKind>{};
    start(bare);
    click(ground());  // beside it
    EXPECT_EQ(scene(), bare);
    click(pixel({0.5 * toward_us_.x, 2 * toward_us_.y, toward_us_.z}));
    ASSERT_TRUE(scene().probe);
    EXPECT_NEAR(glm::length(scene().probe->xyz), 1.0, 0.01);  // of facets, whose middles lie within
    EXPECT_LT(glm::length(scene().probe->xyz - toward_us_), 0.05);
    Scene probed = bare;
    probed.probe = scene().probe;
    EXPECT_EQ(scene(), probed);
    expect_undo({bare, probed});
}

TEST_F(MouseTest, AClickInTheRightHalfOfASplitPicture) {
    Scene split = light();
    split.stack = {};
    split.view = ViewMode::Split;
    split.arrows.show = std::vector<ArrowKind>{};
    start(split);
    click(pixel(toward_us_, 1));
    ASSERT_TRUE(scene().probe);
    EXPECT_LT(glm::length(scene().probe->xyz - toward_us_), 0.05);
}

TEST_F(MouseTest, AClickOnAnArrowPlacesTheProbeAtItsFoot) {
    const auto file = write("octahedron.obj",
                            "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 3 5\nf 3 2 5\nf 2 4 5\n"
                            "f 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n");
    Scene mesh;
    mesh.surface = MeshSurface{file.string()};
    mesh.view = ViewMode::Single;
    mesh.arrows.length = 0.2;
    mesh.show.axes = false;
    start(mesh);
    for (const glm::dvec3 corner : {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0)}) {
        click(pixel(corner + 0.15 * glm::normalize(glm::dvec3(1))));
        ASSERT_TRUE(scene().probe);
        EXPECT_LT(glm::length(scene().probe->xyz - corner), 1e-5);
    }
}

// As a touch screen sends it: the pointer jumps and presses at once.
TEST_F(MouseTest, APressCountsWhereThePointerIs) {
    start();
    const Scene before = scene();
    point({100, 600});  // the panel
    viewer().pointer_to(ground());
    viewer().press(0, 0);
    viewer().pointer_to(ground() + glm::dvec2(50, 0));
    viewer().release(0, 0);
    settle();
    EXPECT_NEAR(scene().camera.azimuth, before.camera.azimuth - 20, 1e-9);
    const Scene after = scene();
    const glm::dvec2 button = middle(Item("##panel/##always") / "inverse transpose" / "##rule");
    viewer().pointer_to(button);
    viewer().press(0, 0);
    viewer().release(0, 0);
    point(ground());
    EXPECT_EQ(scene().camera, after.camera);
}

TEST_F(MouseTest, KeysWaitUntilADragIsOver) {
    start();
    const Scene before = scene();
    point(ground());
    press();
    keys({ImGuiKey_N, ImGuiMod_Ctrl | ImGuiKey_O});
    release();
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(viewer().interface().dialog_shown());
}

TEST_F(MouseTest, WhateverIsLookedAtWhenTheObjectIsFlat) {
    start(light("flattened"));
    const Scene before = scene();
    for (const ImGuiKey each : {ImGuiKey_N, ImGuiKey_C, ImGuiKey_E, ImGuiKey_V, ImGuiKey_V, ImGuiKey_T, ImGuiKey_I})
        key(each);
    EXPECT_EQ(scene().stack, before.stack);
}

TEST_F(MouseTest, TheProbeIsDraggedOverTheSurface) {
    start(light("identity"));
    const Scene before = scene();
    click(pixel(toward_us_));  // from now on it is somewhere
    const Scene placed = scene();
    ASSERT_TRUE(placed.probe);
    const glm::dvec3 to(std::sin(0.6) * std::cos(0.2), std::sin(0.2), std::cos(0.6) * std::cos(0.2));
    drag({pixel(placed.probe->xyz), pixel(glm::normalize(toward_us_ + to)), pixel(to)});
    ASSERT_TRUE(scene().probe);
    EXPECT_LT(glm::length(scene().probe->xyz - to), 0.05);
    EXPECT_EQ(scene().camera, placed.camera);
    const Scene moved = scene();
    // Beside the object it keeps to the outline.
    drag({pixel(scene().probe->xyz), pixel({0, 3, 0})});
    EXPECT_NEAR(glm::length(scene().probe->xyz), 1.0, 0.02);
    EXPECT_GT(scene().probe->xyz.y, 0.8);
    expect_undo({before, placed, moved, scene()});
}

TEST_F(MouseTest, AltAndTheArrowsMoveTheProbe) {
    start(light("identity"));
    click(pixel(toward_us_));
    const glm::dvec3 placed = scene().probe->xyz;
    for (int i = 0; i < 5; ++i) key(ImGuiMod_Alt | ImGuiKey_UpArrow);
    EXPECT_GT(scene().probe->xyz.y, placed.y + 0.05);
    EXPECT_NEAR(glm::length(scene().probe->xyz), 1.0, 0.01);
    for (int i = 0; i < 5; ++i) key(ImGuiMod_Alt | ImGuiKey_DownArrow);
    EXPECT_LT(glm::length(scene().probe->xyz - placed), 0.02);
}

TEST_F(MouseTest, AKnobStaysInThePicture) {
    start();
    const Scene before = scene();
    drag({knob(1, 2), {knob(1, 2).x, 60}, {knob(1, 2).x, 2}});
    const double factor = std::get<Scale>(scene().stack[0]).factors.y;
    EXPECT_GT(factor, 2.2);
    EXPECT_GT(knob(1, factor).y, 8.0) << "it can be dragged back";
    expect_undo({before, scene()});
}

TEST_F(MouseTest, PPinsTheProbesPointAndNoMoreThanFour) {
    for (const ViewMode view : {ViewMode::Overlay, ViewMode::Split, ViewMode::Flat}) {
        Scene scene_before = light();
        scene_before.view = view;
        start(scene_before);
        const Scene before = scene();
        ASSERT_TRUE(viewer().frame()->probe);
        const Point<Object> at = viewer().frame()->probe->object.point;
        key(ImGuiKey_P);
        ASSERT_EQ(scene().pinned, std::vector{at});
        const Scene one = scene();
        key(ImGuiKey_P);
        EXPECT_EQ(scene(), one);
        EXPECT_EQ(message(), "This point is already pinned");
        key(ImGuiMod_Ctrl | ImGuiKey_Z);
        EXPECT_EQ(scene(), before);
        key(ImGuiMod_Ctrl | ImGuiKey_Y);
        for (std::size_t i = 1; i < Scene::kMostPinned; ++i) keys({ImGuiMod_Alt | ImGuiKey_UpArrow, +ImGuiKey_P});
        EXPECT_EQ(scene().pinned.size(), Scene::kMostPinned);
        ASSERT_EQ(viewer().frame()->pinned.size(), Scene::kMostPinned);
        ASSERT_TRUE(viewer().frame()->pinned[0]);
        EXPECT_LT(glm::length(viewer().frame()->pinned[0]->object.point.xyz - at.xyz), 1e-9);
        keys({ImGuiMod_Alt | ImGuiKey_UpArrow, +ImGuiKey_P});
        EXPECT_EQ(scene().pinned.size(), Scene::kMostPinned);
        EXPECT_TRUE(message().starts_with("At most four points can be pinned")) << message();
    }
}

TEST_F(MouseTest, OPutsAPolygonInTheProbesPlaceAndAClickChoosesItsFace) {
    Scene cube = light("identity");
    cube.surface = ShapeSurface{.shape = Shape::Cube};
    start(cube);
    const auto normal = [&] { return viewer().frame()->probe->object.normal.xyz; };
    key(ImGuiKey_O);
    EXPECT_TRUE(scene().show.polygon);
    click(pixel({0.3, 1.0, 0.3}));
    EXPECT_EQ(normal(), glm::dvec3(0, 1, 0));
    EXPECT_EQ(viewer().frame()->probe->object.polygon.size(), 4u);
    click(pixel({0.2, -0.2, 1.0}));
    EXPECT_EQ(normal(), glm::dvec3(0, 0, 1));
    const auto& labels = viewer().frame()->panes[0].labels;
    EXPECT_TRUE(std::ranges::count(labels, "MH", &Label::text) == 1);
    for (int i = 0; i < 3; ++i) key(ImGuiMod_Ctrl | ImGuiKey_Z);
    EXPECT_EQ(scene(), cube);
    EXPECT_TRUE(viewer().frame()->probe->object.polygon.empty());
}

TEST_F(MouseTest, AKnobCatchesAtWholeNumbers) {
    start();
    drag({knob(2, 1), knob(2, 1.4), knob(2, 1.98)});
    EXPECT_EQ(scale().factors.z, 2.0);
}

TEST_F(MouseTest, InAFlatViewTheProbeFollowsTheCurveAndElsewhereADragPans) {
    start(light("flat"));
    while (scene().view != ViewMode::Flat) key(ImGuiKey_V);
    const glm::dvec3 from(0.4, 1.2, 0), beyond(2, 0, 0);
    drag({pixel(from), pixel({0.5, 0.6, 0}), pixel(beyond)});
    ASSERT_TRUE(scene().probe);
    EXPECT_LT(glm::length(scene().probe->xyz - glm::dvec3(1, 0, 0)), 0.06);
    const Scene dragged = scene();
    drag({ground(), ground() + glm::dvec2(40, -30)});
    EXPECT_EQ(scene().camera.azimuth, dragged.camera.azimuth);
    EXPECT_NE(scene().camera.target, dragged.camera.target);
    EXPECT_EQ(scene().probe, dragged.probe);
    // The axes' knobs stretch as ever; that of z would lie over the middle, and is not there.
    drag({pixel({0, 2.3, 0}), pixel({0, 1.5, 0})});
    EXPECT_LT(std::get<Scale>(scene().stack.at(0)).factors.y, 1.6);
    EXPECT_EQ(std::get<Scale>(scene().stack.at(0)).factors.z, 1.0);
}

}  // namespace
}  // namespace normalscope

// The flat view: the cut by z = 0, the plane that it is seen in, and its numbers held against those of space.

#include "core/picture/make_frame.h"
#include "random.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {
namespace {

Scene flat_scene(SurfaceSource surface = ShapeSurface{}, std::vector<StackEntry> stack = {Scale{{0.5, 2.0, 1.0}}}) {
    Scene scene{.surface = std::move(surface), .stack = std::move(stack)};
    scene.view = ViewMode::Flat;
    return scene;
}
Frame frame_of(const Scene& scene) {
    SurfaceCache surfaces;
    return make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {640, 480}}});
}
FlatCut cut_of(const SurfaceSource& surface) {
    SurfaceCache surfaces;
    return flat_cut(*surfaces.get(flat_scene(surface)));
}
double area(const FlatCut& cut) {
    double sum = 0.0;
    for (const auto& [a, b, c, d] : cut.inside) {
        const glm::dvec2 e = c - a, f = d - b;
        sum += 0.5 * std::abs(e.x * f.y - e.y * f.x);
    }
    return sum;
}
TEST(FlatCut, OfShapesAndFormulasIsTheCurveThatOneKnows) {
    constexpr double kPi = glm::pi<double>();
    for (const SurfaceSource& ball :
         {SurfaceSource(ShapeSurface{Shape::Sphere, 256}), SurfaceSource(FormulaSurface{})}) {
        const FlatCut circle = cut_of(ball);
        ASSERT_EQ(circle.curves.size(), 1u);
        EXPECT_TRUE(circle.curves[0].closed);
        EXPECT_NEAR(circle.length, 2.0 * kPi, 2e-3);
        EXPECT_NEAR(area(circle), kPi, 2e-3);
        for (const CurvePiece& piece : circle.curves[0].pieces)
            EXPECT_NEAR(glm::length(piece.from.point.xyz), 1.0, 1e-3);
    }
    const FlatCut square = cut_of(ShapeSurface{Shape::Cube, 8});
    ASSERT_EQ(square.curves.size(), 1u);
    EXPECT_NEAR(square.length, 8.0, 1e-9);
    EXPECT_NEAR(area(square), 4.0, 1e-9);
    // A plane's is a line with two ends; a hyperbola's has four.
    const FlatCut line = cut_of(ShapeSurface{Shape::Plane, 8});
    ASSERT_EQ(line.curves.size(), 1u);
    EXPECT_FALSE(line.curves[0].closed);
    EXPECT_TRUE(line.inside.empty());
    const FlatCut hyperbola = cut_of(FormulaSurface{.formula = "x^2-y^2-z^2-0.1"});
    ASSERT_EQ(hyperbola.curves.size(), 2u);
    EXPECT_FALSE(hyperbola.curves[0].closed || hyperbola.curves[1].closed);
    // Two circles, one within the other: what lies between them is inside.
    const FlatCut ring = cut_of(FormulaSurface{.formula = "(x^2+y^2-1)^2+z^2-0.04"});
    ASSERT_EQ(ring.curves.size(), 2u);
    EXPECT_NEAR(area(ring), kPi * (1.2 - 0.8), 5e-3);
    EXPECT_TRUE(cut_of(FormulaSurface{.formula = "x^2+y^2+(z-1)^2-0.04"}).curves.empty());
}

TEST(FlatCut, OfASurfaceInThePlaneIsOnlyWhatElseCrossesIt) {
    for (const char* formula : {"z", "z^3", "exp(z)-1", "min(|z|,|x|)"}) {
        const FlatCut cut = cut_of(FormulaSurface{.formula = formula});
        EXPECT_TRUE(cut.curves.empty() && cut.misses_a_sheet) << formula;
        const Frame frame = frame_of(flat_scene(FormulaSurface{.formula = formula}));
        ASSERT_TRUE(frame.flat);
        EXPECT_EQ(frame.flat->note, "The surface lies in the plane z = 0: there is no curve to draw.");
    }
    for (const char* formula :
         {"z(x^2+y^2+z^2-1)", "max(z,x^2+y^2-1)", "max(-z,x^2+y^2+z^2-1)", "min(z,x^2+y^2+z^2-1)"}) {
        const FlatCut circle = cut_of(FormulaSurface{.formula = formula});
        ASSERT_EQ(circle.curves.size(), 1u) << formula;
        EXPECT_NEAR(circle.length, 2.0 * glm::pi<double>(), 2e-3) << formula;
    }
    EXPECT_EQ(cut_of(FormulaSurface{.formula = "x z"}).curves.size(), 1u);
}

TEST(FlatCut, ACornerHasTheNormalsOfBothItsSides) {
    const FlatCut square = cut_of(ShapeSurface{Shape::Cube, 8});
    int corners = 0;
    const auto& pieces = square.curves.at(0).pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const glm::dvec3 before = pieces[i].to.normal.xyz, after = pieces[(i + 1) % pieces.size()].from.normal.xyz;
        if (std::abs(glm::dot(before, after)) < 1e-9) ++corners;
    }
    EXPECT_EQ(corners, 4);
}

TEST(FlatView, ShowsWhatSpaceHasWhereMLeavesThePlaneInPlace) {
    Random random(41);
    for (int i = 0; i < 50; ++i) {
        glm::dmat4 m(1.0);
        for (int c = 0; c < 2; ++c)
            for (int r = 0; r < 2; ++r) m[c][r] = random.uniform(-2.0, 2.0);
        if (std::abs(m[0][0] * m[1][1] - m[0][1] * m[1][0]) < 0.05) continue;
        m[2] = {0.0, 0.0, random.uniform(0.2, 2.0), 0.0};
        m[3] = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 1.0};
        Scene scene = flat_scene(FormulaSurface{}, {Matrix{m}});
        scene.probe = Point<Object>{{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0}};
        const Frame flat = frame_of(scene);
        ASSERT_TRUE(flat.probe && flat.flat && flat.flat->n_object);
        scene.view = ViewMode::Overlay;
        scene.probe = flat.probe->object.point;
        const Frame space = frame_of(scene);
        ASSERT_TRUE(space.probe);
        EXPECT_FALSE(flat.flat->plane.tilted);
        EXPECT_EQ(flat.flat->note, "");
        for (const Rule rule : kRules) {
            const glm::dvec3 n = space.probe->normals[rule]->xyz;
            EXPECT_LT(glm::distance(*flat.flat->normals[rule], glm::dvec2(n)), 1e-6 * glm::length(n));
        }
        EXPECT_NEAR(*flat.flat->error_degrees, *space.probe->error_degrees, 1e-5);
        EXPECT_LT(glm::distance(flat.flat->plane.place(flat.probe->point), glm::dvec2(space.probe->point.xyz)), 1e-9);
    }
}

TEST(FlatView, TheRightNormalIsPerpendicularToTheCurveWhateverMDoesToThePlane) {
    Random random(42);
    const std::vector<SurfaceSource> surfaces{ShapeSurface{Shape::Torus, 48}, ShapeSurface{Shape::Cone, 48},
                                              FormulaSurface{.formula = "x^2+2y^2+3z^2+xz-1"}};
    int judged = 0;
    for (int i = 0; i < 60; ++i) {
        Scene scene = flat_scene(surfaces[static_cast<std::size_t>(i) % surfaces.size()], random.stack(4));
        const Transform<World, Object> m = world_from_object(scene);
        if (!m.inverse() || !(m.normal_matrices_by_rule().condition().value_or(1e9) < 1e3)) continue;
        scene.probe = Point<Object>{{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0}};
        const Frame frame = frame_of(scene);
        const FlatView& view = *frame.flat;
        if (!view.truth || !view.tangent) continue;
        ++judged;
        EXPECT_NEAR(glm::dot(glm::normalize(*view.truth), glm::normalize(*view.tangent)), 0.0, 1e-8);
        // The image of the cut lies in the plane, and the camera looks straight at it.
        EXPECT_NEAR(glm::dot(frame.probe->point.xyz - view.plane.origin.xyz, view.plane.normal), 0.0,
                    1e-9 * (1.0 + glm::length(frame.probe->point.xyz)));
        const CameraView& camera = frame.panes.at(0).view;
        EXPECT_LT(glm::distance(camera.right().xyz, view.plane.right), 1e-9);
        EXPECT_LT(glm::distance(camera.up().xyz, view.plane.up), 1e-9);
    }
    EXPECT_GT(judged, 20);
}

TEST(FlatView, AProjectiveMapsPlaneIsAPlaneAndItsNormalIsPerpendicularThere) {
    const glm::dmat4 m(1.0, 0.0, 0.3, 0.2, 0.2, 1.5, 0.0, 0.3, 0.0, 0.0, 1.0, 0.0, 0.0, 0.1, 0.0, 1.0);
    const Frame frame = frame_of(flat_scene(FormulaSurface{}, {Matrix{m}}));
    const FlatView& view = *frame.flat;
    ASSERT_TRUE(view.truth && view.tangent);
    EXPECT_NEAR(glm::dot(glm::normalize(*view.truth), glm::normalize(*view.tangent)), 0.0, 1e-8);
    EXPECT_NEAR(glm::dot(frame.probe->point.xyz - view.plane.origin.xyz, view.plane.normal), 0.0, 1e-9);
    EXPECT_FALSE(view.factors[Rule::Naive]);
}

TEST(FlatView, SaysWhatEachRuleMultipliesXAndYBy) {
    const Frame frame = frame_of(flat_scene());
    EXPECT_EQ(*frame.flat->factors[Rule::Naive], glm::dvec2(0.5, 2.0));
    EXPECT_EQ(*frame.flat->factors[Rule::InverseTranspose], glm::dvec2(2.0, 0.5));
    for (const char* text : {"\u00D7\u00BD", "\u00D72"})
        EXPECT_EQ(std::ranges::count(frame.panes[0].labels, text, &Label::text), 2) << text;
    const Frame turned = frame_of(flat_scene(ShapeSurface{}, {Scale{{0.5, 2.0, 1.0}}, Rotate{{0.0, 0.0, 1.0}, 30.0}}));
    EXPECT_FALSE(turned.flat->factors[Rule::Naive]);
    EXPECT_TRUE(turned.flat->n_object);
}

TEST(FlatView, SaysWhatIsNotAsOneWouldExpect) {
    const auto note = [](const Scene& scene) { return frame_of(scene).flat->note; };
    EXPECT_EQ(note(flat_scene()), "");
    EXPECT_NE(note(flat_scene(FormulaSurface{.formula = "x^2+y^2+(z-1)^2-0.04"})).find("does not cross"),
              std::string::npos);
    EXPECT_NE(note(flat_scene(ShapeSurface{}, {Scale{{0.0, 0.0, 1.0}}})).find("single point"), std::string::npos);
    EXPECT_NE(note(flat_scene(ShapeSurface{}, {Scale{{0.0, 2.0, 1.0}}})).find("to a line"), std::string::npos);
    EXPECT_NE(note(flat_scene(FormulaSurface{}, {Scale{{0.5, 2.0, 0.0}}})).find("straight at you"), std::string::npos);
    EXPECT_NE(note(flat_scene(FormulaSurface{}, {Rotate{{1.0, 0.0, 0.0}, 40.0}})).find("tilts"), std::string::npos);
    EXPECT_NE(note(flat_scene(FormulaSurface{}, {Shear{.zx = 0.5}})).find("leave this plane"), std::string::npos);
}

TEST(FlatView, OfALineTheCofactorIsStillPerpendicular) {
    const Frame frame = frame_of(flat_scene(FormulaSurface{}, {Scale{{0.0, 2.0, 1.0}}}));
    const FlatView& view = *frame.flat;
    ASSERT_TRUE(view.truth && view.tangent);
    EXPECT_NEAR(glm::dot(glm::normalize(*view.truth), glm::normalize(*view.tangent)), 0.0, 1e-12);
    EXPECT_FALSE(view.normals[Rule::InverseTranspose]);
}

TEST(FlatView, APlaceIsWhereThePictureShowsItWhicheverLayerItLiesOn) {
    const Frame frame = frame_of(flat_scene());
    const Pane& pane = frame.panes[0];
    // Everything drawn is unlit, and nothing is behind the plane by more than its layers.
    for (const SolidVertex& vertex : pane.solids) EXPECT_EQ(vertex.normal, glm::vec3(0.0f));
    const glm::dvec2 a(pane.view.pixel({{0.0, 0.0, 0.0}})), b(pane.view.pixel({{1.0, 0.0, 0.0}})),
        c(pane.view.pixel({{0.0, 1.0, 0.0}}));
    EXPECT_NEAR(glm::distance(a, b), glm::distance(a, c), 1e-9);
    EXPECT_LT(glm::distance(a, {320.0, 240.0}), 1e-9);
    EXPECT_TRUE(pane.surfaces.empty() && pane.arrows.empty());
}

}  // namespace
}  // namespace normalscope

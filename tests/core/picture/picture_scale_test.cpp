#include "core/frame/picture_scale.h"

#include "core/picture/make_frame.h"
#include "core/picture/picking.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

using namespace normalscope;

namespace {

constexpr double kScales[]{1e-6, 1e-3, 0.1, 1.0, 30.0, 200.0, 1e4, 1e6};

Scene scaled_torus(double scale, bool framed_camera, ViewMode view = ViewMode::Single) {
    Scene scene;
    scene.surface = ShapeSurface{Shape::Torus, 24};
    scene.stack = {Scale{glm::dvec3(scale)}};
    scene.view = view;
    if (framed_camera) {
        SurfaceCache surfaces;
        const WorldBall ball = bounding_ball(surfaces.get(scene)->mesh, world_from_object(scene));
        scene.camera = framed(scene.camera, ball.centre, ball.radius);
    }
    return scene;
}
Frame frame_of(const Scene& scene) {
    SurfaceCache surfaces;
    return make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {640, 480}}});
}

}  // namespace

TEST(PictureScale, NothingOfTheObjectIsCutOffBehind) {
    for (const double scale : kScales)
        for (const bool framed_camera : {true, false}) {
            const Scene scene = scaled_torus(scale, framed_camera);
            const Frame frame = frame_of(scene);
            const Transform<World, Object> m = world_from_object(scene);
            const CameraView& view = frame.panes.front().view;
            for (const glm::dvec3& p : frame.surface->mesh.positions) {
                const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(m(Point<Object>{p}).xyz, 1.0);
                EXPECT_LT(clip.z, std::abs(clip.w)) << scale << framed_camera;
                if (framed_camera) {
                    EXPECT_GT(clip.z, -clip.w) << scale;
                }
            }
        }
}

// Two places a hundredth of the object's size apart, as far off as it reaches, are apart in a depth buffer of 24 bits.
TEST(PictureScale, DepthsAreToldApart) {
    for (const double scale : kScales)
        for (const bool framed_camera : {true, false}) {
            const Scene scene = scaled_torus(scale, framed_camera);
            const Frame frame = frame_of(scene);
            const CameraView& view = frame.panes.front().view;
            const double depth = farthest_depth(*frame.surface, world_from_object(scene), view);
            if (!framed_camera && scale < 1.0) continue;  // a speck
            const glm::dvec3 along = -glm::normalize(view.eye().xyz - scene.camera.target.xyz);
            const auto at = [&](double d) {
                const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(view.eye().xyz + d * along, 1.0);
                return 0.5 * clip.z / clip.w;
            };
            EXPECT_GT((at(depth) - at(depth - 0.05 * scale)) * (1 << 24), 1.0) << scale << framed_camera;
        }
}

TEST(PictureScale, ArrowsAndMarksKeepTheirShareOfTheObject) {
    EXPECT_EQ(picture_unit(0.4), 1.0);
    EXPECT_EQ(picture_unit(1.0), 1.0);
    EXPECT_EQ(picture_unit(7.0), 1.0);
    EXPECT_NEAR(picture_unit(200.0), 200.0, 1e-9);
    EXPECT_NEAR(picture_unit(1e-3), 1e-3, 1e-12);
    double before = 0.0;
    for (int k = 0; k < 760; ++k) {
        const double r = 1e-8 * std::pow(1.05, k);
        EXPECT_GE(picture_unit(r), before);
        EXPECT_LT(picture_unit(r), std::max(1.2 * before, 2e-8));
        before = picture_unit(r);
    }
    for (const double scale : {1e-6, 200.0, 1e6}) {
        const Frame frame = frame_of(scaled_torus(scale, true));
        for (const ArrowDraw& draw : frame.panes.front().arrows) {
            EXPECT_NEAR(draw.length, 0.24 * scale, 0.01 * scale);
            EXPECT_LT(draw.radius, 0.03 * scale);
        }
        for (const SolidVertex& v : frame.panes.front().solids) EXPECT_LT(glm::length(v.position), 3.0 * scale);
    }
}

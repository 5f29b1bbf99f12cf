#include "ui/probe_trail.h"

#include "core/picture/make_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace normalscope {
namespace {

TEST(ProbeTrail, FollowsTheProbeAndBeginsAnewWhereSomethingElseChanges) {
    SurfaceCache surfaces;
    ProbeTrail trail;
    Scene scene;
    scene.stack = {Scale{{0.5, 2.0, 1.0}}};
    const auto follow = [&] {
        trail.follow(scene, make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {320, 240}}}));
        return trail.size();
    };
    EXPECT_EQ(follow(), 0u);  // the middle of the picture is no way
    const auto at = [](double angle) { return Point<Object>{{std::cos(angle), std::sin(angle), 0.0}}; };
    for (std::size_t i = 1; i <= 5; ++i) {
        scene.probe = at(0.1 * static_cast<double>(i));
        EXPECT_EQ(follow(), i);
    }
    EXPECT_EQ(follow(), 5u);
    scene.camera.azimuth += 10.0;
    scene.pinned.push_back(*scene.probe);
    EXPECT_EQ(follow(), 5u);
    scene.probe = at(0.6);
    EXPECT_EQ(follow(), 6u);
    scene.probe = at(3.0);  // a leap
    EXPECT_EQ(follow(), 1u);
    scene.stack = {Scale{{1.0, 2.0, 1.0}}};
    EXPECT_EQ(follow(), 1u);  // from here on
    scene.probe.reset();
    EXPECT_EQ(follow(), 0u);
}

}  // namespace
}  // namespace normalscope

#include "ui/lecture/exercise_view.h"
#include "core/picture/make_frame.h"

#include "core/surface/surface.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

Frame frame_of(const Scene& scene) {
    SurfaceCache surfaces;
    return make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {400, 300}}});
}

TEST(Exercises, AnArrowThatNobodyMovedIsJudgedTheSecondTime) {
    Scene scene;
    Exercises exercises;
    exercises.start(42, scene);
    const std::string before = exercises.speech().look_at;
    exercises.check(scene);
    EXPECT_FALSE(exercises.answered());
    EXPECT_TRUE(exercises.speech().look_at.starts_with("You have not moved the arrow yet"));
    exercises.turn(frame_of(scene), 0.0, 0.0);
    EXPECT_EQ(exercises.speech().look_at, before);
    exercises.check(scene);
    EXPECT_TRUE(exercises.answered());
    EXPECT_NE(exercises.speech().look_at.find("points"), std::string::npos);

    exercises.next(scene);
    exercises.check(scene);
    EXPECT_FALSE(exercises.answered());
    exercises.check(scene);
    EXPECT_TRUE(exercises.answered());
}

TEST(Exercises, GivesBackTheSceneThatWasThereBefore) {
    Scene scene;
    scene.arrows.limit = 17;
    const Scene before = scene;
    Exercises exercises;
    EXPECT_EQ(exercises.scene_before(scene), before);
    exercises.start(42, scene);
    EXPECT_NE(scene, before);
    exercises.start(43, scene);
    scene.theme = Theme::Dark;
    exercises.leave(scene);
    EXPECT_FALSE(exercises.running());
    EXPECT_EQ(scene.theme, Theme::Dark);
    scene.theme = before.theme;
    EXPECT_EQ(scene, before);
}

}  // namespace
}  // namespace normalscope

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

TEST(Predict, AnArrowThatNobodyMovedIsJudgedTheSecondTime) {
    Scene scene;
    Predict predict;
    predict.start(42, scene);
    const std::string before = predict.speech().look_at;
    predict.check(scene);
    EXPECT_FALSE(predict.answered());
    EXPECT_TRUE(predict.speech().look_at.starts_with("The arrow has not been moved yet"));
    predict.turn(frame_of(scene), 0.0, 0.0);
    EXPECT_EQ(predict.speech().look_at, before);
    predict.check(scene);
    EXPECT_TRUE(predict.answered());
    EXPECT_NE(predict.speech().look_at.find("points"), std::string::npos);

    predict.next(scene);
    predict.check(scene);
    EXPECT_FALSE(predict.answered());
    predict.check(scene);
    EXPECT_TRUE(predict.answered());
}

TEST(Predict, GivesBackTheSceneThatWasThereBefore) {
    Scene scene;
    scene.arrows.limit = 17;
    const Scene before = scene;
    Predict predict;
    EXPECT_EQ(predict.scene_before(scene), before);
    predict.start(42, scene);
    EXPECT_NE(scene, before);
    predict.start(43, scene);
    scene.theme = Theme::Dark;
    predict.leave(scene);
    EXPECT_FALSE(predict.running());
    EXPECT_EQ(scene.theme, Theme::Dark);
    scene.theme = before.theme;
    EXPECT_EQ(scene, before);
}

}  // namespace
}  // namespace normalscope

#include "ui/predict.h"

#include "core/surface.h"

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

}  // namespace
}  // namespace normalscope

#include "core/scene/history.h"
#include "core/scene/scene.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

Scene about(int i) {
    Scene scene;
    scene.about = std::to_string(i);
    return scene;
}

TEST(History, UndoesAndRedoes) {
    History history(about(0));
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.undo(), about(0));
    EXPECT_EQ(history.redo(), about(0));
    history.commit(about(1));
    history.commit(about(1));  // no change
    history.commit(about(2));
    EXPECT_EQ(history.undo(), about(1));
    EXPECT_EQ(history.undo(), about(0));
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.redo(), about(1));
    history.commit(about(3));  // forgets 2
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo(), about(1));
}

TEST(History, ForgetsTheOldest) {
    History history(about(0));
    for (int i = 1; i < 2000; ++i) history.commit(about(i));
    int steps = 0;
    for (; history.can_undo(); ++steps) history.undo();
    EXPECT_GE(steps, 100);
    EXPECT_LT(steps, 1000);
    EXPECT_EQ(history.current(), about(1999 - steps));
}

}  // namespace
}  // namespace normalscope

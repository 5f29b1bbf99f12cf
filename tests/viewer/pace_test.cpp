#include "viewer/pace.h"

#include <gtest/gtest.h>

#include <chrono>

namespace normalscope {
namespace {

using std::chrono::milliseconds;

void move(Pace& pace, int frames, milliseconds each) {
    for (int i = 0; i < frames; ++i) {
        pace.rough(true);
        pace.took(each);
    }
}

TEST(Pace, FewerSamplesThenFewerRaysWhereFramesTakeTheirTime) {
    Pace pace;
    move(pace, 10, milliseconds(18));
    EXPECT_FALSE(pace.rough(true)) << "more than fifty a second are enough";
    move(pace, 1, milliseconds(25));
    EXPECT_FALSE(pace.rough(true)) << "one alone compiled a shader";
    move(pace, 1, milliseconds(25));
    EXPECT_TRUE(pace.rough(true));
    move(pace, 10, milliseconds(25));
    EXPECT_FALSE(pace.coarse()) << "what is seen to be coarse has to be worth it";
    move(pace, 2, milliseconds(40));
    EXPECT_TRUE(pace.coarse());
}

TEST(Pace, WhatRestsIsDrawnInFullAndWhatMovesNextBeginsSo) {
    Pace pace;
    move(pace, 10, milliseconds(40));
    EXPECT_FALSE(pace.rough(false));
    EXPECT_FALSE(pace.coarse());
    EXPECT_FALSE(pace.rough(true));
}

}  // namespace
}  // namespace normalscope

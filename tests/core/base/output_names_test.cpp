#include "core/base/output_names.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

TEST(OutputNames, OnlyAWidthAndADAreAPlaceForANumber) {
    EXPECT_EQ(numbered("a-%d.png", 7), "a-7.png");
    EXPECT_EQ(numbered("a-%03d.png", 7), "a-007.png");
    EXPECT_EQ(numbered("turn-%d/a-%2d.png", 7, 3), "turn-2/a-01.png");
    for (const std::string name :
         {"50% done/%d.png", "feature%2Fx/%d.png", "%/%d.png", "%s%%d/%d.png", "%1234d%d.png"}) {
        EXPECT_EQ(places_for_numbers(name), 1U) << name;
        EXPECT_TRUE(numbered(name, 7).string().ends_with("7.png")) << name;
    }
    for (const std::string name : {"a.png", "100%", "%%d", "%", "%2", "%-d.png"})
        EXPECT_EQ(places_for_numbers(name), 0U) << name;
}

TEST(OutputNames, WhatIsTakenLiterallyStaysAsItIs) {
    for (const std::string name : {"50% done", "p%dq", "feature%2Fx", "%%", "%03d%", "%"}) {
        EXPECT_EQ(places_for_numbers(literally(name)), 0U) << name;
        EXPECT_EQ(numbered(literally(name), 7), name);
        EXPECT_EQ(numbered(literally(name) + "%d", 7), name + "7");
    }
}

}  // namespace
}  // namespace normalscope

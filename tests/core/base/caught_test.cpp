#include "core/base/caught.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

TEST(Caught, AtWhatOneMeansAndNowhereElse) {
    for (const double meant : {0.0, 0.5, 1.0, 2.0, -1.0})
        for (const double off : {-0.04, 0.0, 0.04}) EXPECT_EQ(caught(meant + off, 0.05), meant);
    for (const double free : {0.06, 0.44, 0.75, 1.5, 2.06, -0.5, -1.06, 3.0}) EXPECT_EQ(caught(free, 0.05), free);
    EXPECT_EQ(caught(0.97, 0.0), 0.97);
}

}  // namespace
}  // namespace normalscope

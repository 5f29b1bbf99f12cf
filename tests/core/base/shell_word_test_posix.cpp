#include "core/base/system.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

TEST(ShellWord, OfPosix) {
    EXPECT_EQ(shell_word("a-b_c.obj"), "a-b_c.obj");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace normalscope

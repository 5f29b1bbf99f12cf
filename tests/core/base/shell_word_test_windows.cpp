#include "core/base/system.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

TEST(ShellWord, OfCmdAndPowerShell) {
    EXPECT_EQ(shell_word("rule=naive"), "rule=naive");
    EXPECT_EQ(shell_word("C:\\a\\b.obj"), "C:\\a\\b.obj");
    EXPECT_EQ(shell_word("it's"), "\"it's\"");
    EXPECT_EQ(shell_word("stack.0.scale=[1,2,1]"), "\"stack.0.scale=[1,2,1]\"")
        << "PowerShell takes a comma for a list";
    EXPECT_EQ(shell_word("C:\\a b\\"), "\"C:\\a b\\\\\"");
    EXPECT_EQ(shell_word("a\"b"), "\"a\\\"\"b\"");
    EXPECT_EQ(shell_word(""), "\"\"");
}

}  // namespace
}  // namespace normalscope

#include "core/scene/typed_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace normalscope {
namespace {

TEST(TypedNumber, IsReadAsPeopleTypeIt) {
    const double pi = std::numbers::pi;
    for (const auto& [text, value] : {std::pair<const char*, double>{"0.5", 0.5},
                                      {"1/2", 0.5},
                                      {"0,5", 0.5},
                                      {"-1.5e0", -1.5},
                                      {"1e-3", 0.001},
                                      {"2*3", 6.0},
                                      {"−√2", -std::sqrt(2.0)},
                                      {"pi/4", pi / 4},
                                      {" 7 ", 7.0},
                                      {"30°", 30.0},
                                      {"sqrt(3)/2", std::sqrt(3.0) / 2},
                                      {".25", 0.25},
                                      {"+2", 2.0},
                                      {"½", 0.5},
                                      {"−2¾", -2.75}})
        EXPECT_EQ(typed_number(text), value) << text;
}

TEST(TypedNumber, IsNothingElse) {
    for (const char* text : {"", "nan", "inf", "1e999", "1/", "1/0", "x", "2a", "0x", "0.abc", "x-x", "1,2,3", "one",
                             "sqrt(-1)", "1 = 2 =", "--"})
        EXPECT_EQ(typed_number(text), std::nullopt) << text;
}

}  // namespace
}  // namespace normalscope

#include "core/base/math_text.h"

#include "core/base/html.h"

#include <gtest/gtest.h>

namespace normalscope {
namespace {

TEST(MathText, NamesHaveWhatStandsBelowAndAboveThem) {
    EXPECT_EQ(html_math("M_3 x^2 n_obj"),
              "<i>M</i><sub>3</sub> <i>x</i><sup>2</sup> <span><i>n</i><sub>obj</sub></span>");
    EXPECT_EQ(html_math("(M_3^{-1})^T n_world"), html_math("(M₃⁻¹)ᵀ n_world"));
    EXPECT_EQ(html_math("(M₃⁻¹)ᵀ"), "(<i>M</i><sub>3</sub><sup>−1</sup>)<sup>T</sup>");
    EXPECT_EQ(html_math("n_worldᵀ"), "<span class=\"right\"><i>n</i><sub>world</sub></span><sup>T</sup>");
    EXPECT_EQ(html_math("((R S)⁻¹)ᵀ"), "((R S)<sup>−1</sup>)<sup>T</sup>");
    EXPECT_EQ(html_math("10^-3"), "10<sup>−3</sup>");
}

TEST(MathText, FractionsRootsMatricesBold) {
    EXPECT_EQ(html_math("{1}/{x}"), "<math><mfrac><mrow><mn>1</mn></mrow><mrow><mi>x</mi></mrow></mfrac></math>");
    EXPECT_EQ(html_math("√{x^2}"),
              "<math><msqrt><msup><mrow><mi>x</mi></mrow><mrow><mn>2</mn></mrow></msup></msqrt></math>");
    EXPECT_EQ(html_math("[1, 0; 0, 2]").find("<math><mrow><mo>[</mo><mtable><mtr><mtd>"), 0u);
    EXPECT_EQ(html_math("**M** n"), "<b>M</b> n");
    EXPECT_EQ(plain_math("{a + b}/{2}, √{x}, [1, 0; 0, 2], **b**, M_3^{-1}, n_obj, x^k"),
              "(a + b)/2, √x, [1, 0; 0, 2], b, M₃⁻¹, n_obj, x^k");
}

// Sentences are not to be mistaken for mathematics, whatever signs stand in them.
TEST(MathText, WhatIsNoMathematicsStays) {
    for (const char* words :
         {"a _ b", "{x}", "{",  "}/{", "{a}/b", "[x]", "[1, 2; 3]", "2 ** 3", "**", "****",    "^",
          "_",     "a^",  "a_", "√2",  "√{",    "[;",  ")",         "(",      "x)", "½ of it", "法线"})
        EXPECT_EQ(html_math(words), words);
    EXPECT_EQ(html_math("my\\_file \\{a}/{b}"), "my_file {a}/{b}");
    EXPECT_EQ(html_math("a < b"), "a &lt; b");
    EXPECT_EQ(html_math("x)²"), "x)<sup>2</sup>");
}

}  // namespace
}  // namespace normalscope

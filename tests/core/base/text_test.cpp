#include "core/base/text.h"
#include "core/base/base64.h"
#include "core/base/utf8.h"

#include <gtest/gtest.h>

#include <vector>

namespace normalscope {
namespace {

TEST(Text, ListsOfWords) {
    const std::vector<std::string> words{"one", "two", "three"};
    EXPECT_EQ(joined(words), "one, two, three");
    EXPECT_EQ(joined(words, " "), "one two three");
    EXPECT_EQ(joined({}), "");
    EXPECT_EQ(alternatives(words), "one, two or three");
    EXPECT_EQ(alternatives(std::span(words).first(1)), "one");
}

TEST(Text, IsShortenedBetweenCharacters) {
    EXPECT_EQ(shortened("ααα", 6), "ααα");
    EXPECT_EQ(shortened("αααα", 6), "α…") << "6 bytes hold one letter and a half beside the three of …";
    EXPECT_EQ(shortened("abc", 2), "…");
}

TEST(Text, StaysInOneLine) { EXPECT_EQ(in_one_line("a\nb\tc\x7f"), "a�b�c�"); }

// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
    const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                   {"f", "Zg=="},
                                                                   {"fo", "Zm8="},
                                                                   {"foo", "Zm9v"},
                                                                   {"foob", "Zm9vYg=="},
                                                                   {"fooba", "Zm9vYmE="},
                                                                   {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors) {
        EXPECT_EQ(base64(bytes), text);
        EXPECT_EQ(base64url(bytes), text.substr(0, text.find('=')));
        EXPECT_EQ(from_base64url(base64url(bytes)), bytes);
    }
    EXPECT_EQ(base64("\xfb\xff"), "+/8=");
    EXPECT_EQ(base64url("\xfb\xff"), "-_8");
    EXPECT_EQ(from_base64url("Zm9v\n Yg"), "foob");
    EXPECT_FALSE(from_base64url("Zm9v*"));
}

}  // namespace
}  // namespace normalscope

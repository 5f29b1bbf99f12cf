#include "core/base/decimal.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace normalscope {
namespace {

TEST(Decimal, IsWhatCReads) {
    for (const char* text : {"0",
                             "-0",
                             "1",
                             "-1.5",
                             ".5",
                             "5.",
                             "007.250",
                             "0.1",
                             "123456.789012345",
                             "3.14159265358979323846",
                             "1234567890123456789",
                             "1.7976931348623157e308",
                             "2.2250738585072011e-308",
                             "4.9e-324",
                             "1e22",
                             "1e23",
                             "9007199254740993",
                             "8.5e-1",
                             "1E+5",
                             "1e-05",
                             "000000000000000000000.25",
                             "1e999",
                             "-1e999",
                             "1e-999",
                             "1e99999999999999999999",
                             "0e99999999999999999999",
                             "179769313486231570000000000000000000000000000000.0e261"}) {
        double number = 7.0;
        EXPECT_EQ(read_decimal(text, number), std::string(text).size()) << text;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(number), std::bit_cast<std::uint64_t>(std::strtod(text, nullptr)))
            << text;
    }
    std::mt19937_64 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const auto given = std::bit_cast<double>(random());
        if (!std::isfinite(given)) continue;
        for (const char* format : {"%.17g", "%.9e", "%.6f", "%.3g"}) {
            char text[400];
            std::snprintf(text, sizeof text, format, i % 2 == 0 ? given : std::remainder(given, 1000.0));
            EXPECT_EQ(decimal(text), std::strtod(text, nullptr)) << text;
        }
    }
}

TEST(Decimal, EndsWhereTheNumberDoes) {
    double number = 0.0;
    EXPECT_EQ(read_decimal("1.5 2", number), 3u);
    EXPECT_EQ(read_decimal("1e", number), 1u);
    EXPECT_EQ(read_decimal("1e+", number), 1u);
    EXPECT_EQ(read_decimal("2.5.1", number), 3u);
    EXPECT_EQ(number, 2.5);
    for (const char* none : {"", "-", ".", "-.", "e5", "+1", " 1", "nan", "inf", "x"}) {
        EXPECT_EQ(read_decimal(none, number), 0u) << none;
        EXPECT_EQ(decimal(none), std::nullopt) << none;
    }
    for (const char* more : {"1 ", "1x", "0x1", "1,5", "1e"}) EXPECT_EQ(decimal(more), std::nullopt) << more;
}

TEST(Decimal, IsWrittenAsCWritesIt) {
    const auto in_c = [](const char* format, int precision, double number) {
        char text[500];
        std::snprintf(text, sizeof text, format, precision, number);
        return std::string(text);
    };
    for (const double number :
         {0.0, -0.0, 1.0, -1.5, 0.5, 2.5, 0.05, 999.9996, 1e-7, 123456789.0, 1e22, -1.7976931348623157e308, 4.9e-324,
          std::numbers::pi, std::numeric_limits<double>::infinity()})
        for (const int precision : {0, 1, 2, 3, 6, 9, 12, 17}) {
            EXPECT_EQ(with_decimals(number, precision), in_c("%.*f", precision, number));
            EXPECT_EQ(with_digits(number, precision), in_c("%.*g", precision, number));
            EXPECT_EQ(with_exponent(number, precision), in_c("%.*e", precision, number));
        }
}

}  // namespace
}  // namespace normalscope

#include "core/program/waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace normalscope::formulas {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Whether the library's sine, which is the measure here, is one far from 0: Windows' subtracts a π of 66 bits.
#ifdef _WIN32
constexpr bool kLibraryReachesFar = false;
#else
constexpr bool kLibraryReachesFar = true;
#endif

double unit_in_the_last_place(long double of) {
    const double size = std::abs(static_cast<double>(of));
    return size - std::nextafter(size, 0.0);
}

TEST(Waves, AreWithinAUnitInTheLastPlace) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    std::vector<double> places{0.0, -0.0, 5e-324, 1e-300, 1e-9, std::numbers::pi / 4.0};
    if (kLibraryReachesFar) places.insert(places.end(), {1e5, -1e5, 1.1e5, 1e22, 1e300});
    for (int k = 0; k < 100'000; ++k) {
        places.push_back(kLibraryReachesFar ? 10.0 * any(random) : any(random));
        if (!kLibraryReachesFar) continue;
        places.push_back(1e5 * any(random));
        // Near a multiple of π/2, where one of both is almost 0.
        const double multiple = std::round(6e4 * any(random)) * (0.5 * std::numbers::pi);
        places.push_back(multiple * (1.0 + 1e-15 * any(random)));
    }
    for (const double x : places) {
        const long double sine = std::sin(static_cast<long double>(x)), cosine = std::cos(static_cast<long double>(x));
        ASSERT_LE(std::abs(sines(std::array{x}, 0)[0] - sine), unit_in_the_last_place(sine)) << "sin " << x;
        ASSERT_LE(std::abs(sines(std::array{x}, 1)[0] - cosine), unit_in_the_last_place(cosine)) << "cos " << x;
    }
}

TEST(Waves, KeepWhatHoldsExactly) {
    EXPECT_EQ(sines(std::array{0.0}, 1)[0], 1.0);
    for (const double none : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_TRUE(std::isnan(sines(std::array{none}, 0)[0]) && std::isnan(sines(std::array{none}, 1)[0]));
    for (double x = 0.01; x < 2e5; x *= 1.1) {
        EXPECT_EQ(sines(std::array{-x}, 0)[0], -sines(std::array{x}, 0)[0]);
        EXPECT_EQ(sines(std::array{-x}, 1)[0], sines(std::array{x}, 1)[0]);
    }
}

TEST(Waves, AreTheSameForOneAsForMany) {
    const std::array x{0.3, -2.0, 7e4, 2e5, 1e-8, 100.0, -0.0, 3.0};
    for (const std::uint64_t quarters : {0u, 1u}) {
        const std::array many = sines(x, quarters);
        for (std::size_t k = 0; k < x.size(); ++k) EXPECT_EQ(many[k], sines(std::array{x[k]}, quarters)[0]) << x[k];
    }
}

}  // namespace
}  // namespace normalscope::formulas

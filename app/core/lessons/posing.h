#pragma once

// What exercises are made of.

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace normalscope {

struct Exercise;
struct Question;

/// Numbers from a seed, the same on every machine (SplitMix64: Steele, Lea and Flood 2014); the standard's distributions
/// are not.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15ull;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11) * 0x1.0p-53;
    }
    template <class T, std::size_t N>
    T one_of(const std::array<T, N>& all) {
        return all[static_cast<std::size_t>(below(static_cast<int>(N)))];
    }

private:
    std::uint64_t state_;
};

/// What M multiplies a coordinate by, and how that and its inverse are written.
struct Factor {
    double value;
    const char* text;
    const char* inverse;
};
inline constexpr std::array<Factor, 5> kFactors{
    {{0.5, "½", "2"}, {2.0, "2", "½"}, {0.4, "0.4", "2.5"}, {1.6, "1.6", "0.625"}, {2.5, "2.5", "0.4"}}};

/// As people write it: up to six digits, and a true minus.
std::string plain_number(double value);
/// "diag(1, 2, 1)"
std::string diagonal(const glm::dvec3& d);

/// A short question instead of an arrow: sets the exercise's scene, task and reason, and gives its choices.
Question make_question(Exercise& exercise, Dice& dice);

}  // namespace normalscope

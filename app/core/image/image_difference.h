#pragma once

#include "core/image/image.h"

#include <array>
#include <cstdint>

namespace normalscope {

/// What is allowed between two pictures that are to agree.
struct Tolerance {
    int channel = 3;         ///< of 255: how far a pixel may be off
    double share = 0.001;    ///< of the pixels may be further off
    bool perceived = false;  ///< as seen, and edges' smoothing forgiven, rather than in any channel
};

/// How far two pictures of one size are apart. Channels count from 0 to 255; what is wholly transparent in both agrees,
/// whatever colour it would have.
struct ImageDifference {
    std::array<int, 4> most{};       ///< red, green, blue, alpha
    std::array<double, 4> mean{};    ///< over all pixels
    std::int64_t pixels_beyond = 0;  ///< with a channel further off than the tolerance
    double share_beyond = 0.0;       ///< of all pixels
    glm::ivec2 worst{0};             ///< the pixel with the largest difference in any channel, from the top left
    int worst_by = 0;
    /// The same as it is seen (core/image/perceived_difference.h), without those that only smooth an edge; not looked at
    /// in very large pictures, where that would take half a minute and is not what decides.
    bool looked_at = true;
    std::int64_t seen_beyond = 0;
    double share_seen = 0.0;
    double most_seen = 0.0;
    std::int64_t edges_forgiven = 0;  ///< pixels that would be beyond, but only smooth an edge

    bool within(const Tolerance& t) const { return (t.perceived ? share_seen : share_beyond) <= t.share; }
};

/// The most pixels of which it is judged how they are seen.
inline constexpr std::int64_t kMostLookedAt = std::int64_t{1} << 25;

/// The pictures must be of one size. Throws InputError where so many pixels cannot be judged as the tolerance wants.
ImageDifference image_difference(const Image& actual, const Image& expected, const Tolerance& tolerance);

/// The same for pictures that come in parts, from the top on, each of as many rows of both.
class Differences {
public:
    /// Throws as image_difference does.
    Differences(glm::ivec2 size, const Tolerance& tolerance);
    /// How they are seen is looked at within the part: what is not too large for that must come whole.
    void add(const Image& actual, const Image& expected, int first_row);
    ImageDifference result() const;

private:
    void add_pixel(const Image& actual, const Image& expected, glm::ivec2 p, int first_row);

    glm::ivec2 size_;
    Tolerance tolerance_;
    ImageDifference result_;
    std::array<std::int64_t, 4> sums_{};
};

/// Whether difference_picture would be a picture too large to be read again.
bool too_large_to_show(glm::ivec2 actual_size, glm::ivec2 expected_size);

/// Actual, expected and where they differ, side by side on white: red beyond the tolerance, yellow within it or forgiven,
/// and a frame about the worst spot. Where the sizes differ, what only one of them covers counts as different.
Image difference_picture(const Image& actual, const Image& expected, const Tolerance& tolerance);

}  // namespace normalscope

#include "core/image/image_difference.h"

#include "core/base/error.h"
#include "core/image/perceived_difference.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>

namespace normalscope {

namespace {

using Color = std::array<std::uint8_t, 3>;
constexpr Color kWhite{255, 255, 255}, kGap{128, 128, 128}, kBeyond{214, 0, 28}, kWithin{255, 190, 0},
    kFrame{0, 90, 200};
constexpr int kGapWidth = 8;

std::array<int, 4> apart(const std::uint8_t* a, const std::uint8_t* b) {
    if (a[3] == 0 && b[3] == 0) return {};
    std::array<int, 4> off{};
    for (std::size_t c = 0; c < 4; ++c) off[c] = std::abs(a[c] - b[c]);
    return off;
}

Color over_white(const std::uint8_t* p) {
    Color color{};
    for (std::size_t c = 0; c < 3; ++c) color[c] = static_cast<std::uint8_t>(255 + (p[c] - 255) * p[3] / 255);
    return color;
}

bool covers(const Image& image, glm::ivec2 p) { return p.x < image.size.x && p.y < image.size.y; }

void put(Image& image, glm::ivec2 p, Color color) {
    if (p.x < 0 || p.y < 0 || !covers(image, p)) return;
    std::ranges::copy(color, image.pixel(p.x, p.y));
    image.pixel(p.x, p.y)[3] = 255;
}

// The expected picture as a pale grey ghost, on which the differences stand out.
Color ghost(const std::uint8_t* p) {
    const Color c = over_white(p);
    const int grey = (54 * c[0] + 183 * c[1] + 19 * c[2]) / 256;
    const auto pale = static_cast<std::uint8_t>(170 + grey / 3);
    return {pale, pale, pale};
}

bool is_beyond(const Image& actual, const Image& expected, glm::ivec2 p, int largest, const Tolerance& t) {
    if (!t.perceived) return largest > t.channel;
    return largest > 0 && perceived_difference(actual, expected, p) > t.channel &&
           !smooths_an_edge(actual, expected, p);
}

Color verdict(const Image& actual, const Image& expected, glm::ivec2 p, const Tolerance& tolerance) {
    const bool in_actual = covers(actual, p), in_expected = covers(expected, p);
    if (!in_actual && !in_expected) return kWhite;
    if (in_actual != in_expected) return kBeyond;
    const bool comparable = actual.size == expected.size;  // or a pixel's neighbours may not exist
    const int off = std::ranges::max(apart(actual.pixel(p.x, p.y), expected.pixel(p.x, p.y)));
    if (comparable ? is_beyond(actual, expected, p, off, tolerance) : off > tolerance.channel) return kBeyond;
    return off > 0 ? kWithin : ghost(expected.pixel(p.x, p.y));
}

}  // namespace

Differences::Differences(glm::ivec2 size, const Tolerance& tolerance) : size_(size), tolerance_(tolerance) {
    result_.looked_at = std::int64_t{size.x} * size.y <= kMostLookedAt;
    if (tolerance.perceived && !result_.looked_at)
        throw InputError("--perceptual: " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                         " pixels are too many, at most " + std::to_string(kMostLookedAt) +
                         " are judged as they are seen; compare without it, or smaller pictures");
}

void Differences::add(const Image& actual, const Image& expected, int first_row) {
    const auto row_bytes = 4 * static_cast<std::size_t>(expected.size.x);
    for (int y = 0; y < expected.size.y; ++y) {
        // Mostly all of it is the same.
        if (std::memcmp(actual.pixel(0, y), expected.pixel(0, y), row_bytes) == 0) continue;
        for (int x = 0; x < expected.size.x; ++x)
            if (std::memcmp(actual.pixel(x, y), expected.pixel(x, y), 4) != 0)
                add_pixel(actual, expected, {x, y}, first_row);
    }
}

void Differences::add_pixel(const Image& actual, const Image& expected, glm::ivec2 p, int first_row) {
    const std::array<int, 4> off = apart(actual.pixel(p.x, p.y), expected.pixel(p.x, p.y));
    for (std::size_t c = 0; c < 4; ++c) {
        result_.most[c] = std::max(result_.most[c], off[c]);
        sums_[c] += off[c];
    }
    const int largest = std::ranges::max(off);
    if (largest > tolerance_.channel) ++result_.pixels_beyond;
    if (largest > 0 && result_.looked_at) {
        const double seen = perceived_difference(actual, expected, p);
        const bool edge = seen > tolerance_.channel && smooths_an_edge(actual, expected, p);
        if (edge)
            ++result_.edges_forgiven;
        else
            result_.most_seen = std::max(result_.most_seen, seen);
        if (seen > tolerance_.channel && !edge) ++result_.seen_beyond;
    }
    if (largest > result_.worst_by) {
        result_.worst_by = largest;
        result_.worst = {p.x, first_row + p.y};
    }
}

ImageDifference Differences::result() const {
    ImageDifference result = result_;
    const double pixels = static_cast<double>(size_.x) * size_.y;
    for (std::size_t c = 0; c < 4; ++c) result.mean[c] = static_cast<double>(sums_[c]) / pixels;
    result.share_beyond = static_cast<double>(result.pixels_beyond) / pixels;
    result.share_seen = static_cast<double>(result.seen_beyond) / pixels;
    return result;
}

ImageDifference image_difference(const Image& actual, const Image& expected, const Tolerance& tolerance) {
    Differences differences(expected.size, tolerance);
    differences.add(actual, expected, 0);
    return differences.result();
}

bool too_large_to_show(glm::ivec2 actual_size, glm::ivec2 expected_size) {
    const glm::ivec2 size = glm::max(actual_size, expected_size);
    return (3 * std::int64_t{size.x} + 2 * std::int64_t{kGapWidth}) * size.y > kMostPixels;
}

Image difference_picture(const Image& actual, const Image& expected, const Tolerance& tolerance) {
    const glm::ivec2 size = glm::max(actual.size, expected.size);
    const int second = size.x + kGapWidth, third = 2 * second;
    Image picture = make_image({third + size.x, size.y});
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            put(picture, {x, y}, covers(actual, {x, y}) ? over_white(actual.pixel(x, y)) : kWhite);
            put(picture, {second + x, y}, covers(expected, {x, y}) ? over_white(expected.pixel(x, y)) : kWhite);
            put(picture, {third + x, y}, verdict(actual, expected, {x, y}, tolerance));
        }
        for (int x = 0; x < kGapWidth; ++x) {
            put(picture, {size.x + x, y}, kGap);
            put(picture, {second + size.x + x, y}, kGap);
        }
    }
    if (actual.size != expected.size) return picture;

    const ImageDifference difference = image_difference(actual, expected, tolerance);
    if ((tolerance.perceived ? difference.seen_beyond : difference.pixels_beyond) == 0) return picture;
    constexpr int kReach = 10;  // far enough not to hide the spot's surroundings
    for (int i = -kReach; i <= kReach; ++i)
        for (const glm::ivec2 d : {glm::ivec2{i, -kReach}, {i, kReach}, {-kReach, i}, {kReach, i}}) {
            const glm::ivec2 p = difference.worst + d;
            if (p.x >= 0 && p.x < size.x) put(picture, {third + p.x, p.y}, kFrame);
        }
    return picture;
}

}  // namespace normalscope

#include "commands/tab_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace normalscope {

namespace {

constexpr int kBelow = 16;     // pixels of ground below the last line
constexpr int kAboutRule = 4;  // pixels around a line that are ground

std::uint32_t pixel_of(const Image& image, int x, int y) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, image.pixel(x, y), sizeof pixel);
    return pixel;
}

bool is_ground(const Image& image, int y) {
    const std::uint32_t ground = pixel_of(image, image.size.x - 1, image.size.y - 1);
    for (int x = 0; x < image.size.x; ++x)
        if (pixel_of(image, x, y) != ground) return false;
    return true;
}

void put(const Image& image, Image& onto, int left) {
    for (int y = 0; y < std::min(image.size.y, onto.size.y); ++y)
        std::copy_n(image.pixel(0, y), 4 * image.size.x, onto.pixel(left, y));
}

// A line across it, above which a section begins.
bool is_rule(const Image& image, int y) {
    return !is_ground(image, y) && is_ground(image, y - kAboutRule) && is_ground(image, y + kAboutRule) &&
           pixel_of(image, image.size.x / 4, y) == pixel_of(image, image.size.x / 2, y) &&
           pixel_of(image, image.size.x / 2, y) == pixel_of(image, 3 * image.size.x / 4, y) &&
           pixel_of(image, image.size.x / 2, y) != pixel_of(image, image.size.x / 2, y - kAboutRule);
}

// Where a section begins about there, or the widest gap between lines is.
int cut_near(const Image& image, int y, int within) {
    const int first = std::max(y - within, kAboutRule), last = std::min(y + within, image.size.y - 1 - kAboutRule);
    for (int k = 0; k <= within; ++k)
        for (const int rule : {y - k, y + k})
            if (rule >= first && rule <= last && is_rule(image, rule)) return rule - kAboutRule + 1;
    int best = y, widest = 0, begin = -1;
    for (int k = first; k <= last; ++k) {
        if (!is_ground(image, k)) {
            begin = -1;
            continue;
        }
        if (begin < 0) begin = k;
        if (k - begin > widest) widest = k - begin, best = (begin + k) / 2;
    }
    return best;
}

}  // namespace

Image filled(glm::ivec2 size, const glm::vec3& color) {
    Image image = make_image(size);
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        image.rgba[i] = i % 4 == 3 ? std::uint8_t{255}
                                   : static_cast<std::uint8_t>(std::lround(255.0f * color[static_cast<int>(i % 4)]));
    return image;
}

Image what_is_full(const Image& image, int left) {
    const Image part = cropped(image, {left, 0}, {image.size.x - left, image.size.y});
    int height = part.size.y;
    while (height > 1 && is_ground(part, height - 1)) --height;
    return cropped(part, {0, 0}, {part.size.x, std::min(height + kBelow, part.size.y)});
}

Image in_columns(const Image& image, int columns) {
    if (columns == 1) return image;
    const int each = image.size.y / columns;
    std::vector<Image> parts;
    int from = 0, highest = 0;
    for (int k = 1; k <= columns; ++k) {
        const int to = k == columns ? image.size.y : cut_near(image, k * each, each / 3);
        parts.push_back(cropped(image, {0, from}, {image.size.x, to - from}));
        highest = std::max(highest, to - from);
        from = to;
    }
    const std::uint8_t* ground = image.pixel(image.size.x - 1, image.size.y - 1);
    Image all = filled({columns * image.size.x, highest + kBelow}, glm::vec3(ground[0], ground[1], ground[2]) / 255.0f);
    for (int k = 0; k < columns; ++k) put(parts[static_cast<std::size_t>(k)], all, k * image.size.x);
    return all;
}

Image with_at_right(const Image& image, const Image& right, const glm::vec3& ground) {
    Image both = filled({image.size.x + right.size.x, image.size.y}, ground);
    put(image, both, 0);
    put(right, both, image.size.x);
    return both;
}

}  // namespace normalscope

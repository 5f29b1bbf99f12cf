#include "commands/contact_sheet.h"

#include <algorithm>
#include <array>

namespace normalscope {

namespace {

constexpr int kLongest = 2560, kGap = 4;
constexpr std::uint8_t kGapGrey = 128;

// The mean over squares of side × side pixels, which is also what a smaller picture's samples would give.
void put_shrunk(const Image& from, int side, glm::ivec2 origin, Image& to) {
    for (int y = 0; y < from.size.y / side; ++y)
        for (int x = 0; x < from.size.x / side; ++x) {
            std::array<int, 4> sum{};
            for (int v = 0; v < side; ++v) {
                const std::uint8_t* row = from.pixel(x * side, y * side + v);
                for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(side); ++i) sum[i % 4] += row[i];
            }
            for (std::size_t c = 0; c < 4; ++c)
                to.pixel(origin.x + x, origin.y + y)[c] =
                    static_cast<std::uint8_t>((sum[c] + side * side / 2) / (side * side));
        }
}

}  // namespace

Image contact_sheet(std::size_t count, std::size_t columns, const std::function<Image(std::size_t i)>& picture) {
    const auto across = static_cast<int>(columns), down = static_cast<int>((count + columns - 1) / columns);
    Image first = picture(0);
    const auto divided = [](int pixels, int cells) { return (cells * pixels + kLongest - 1) / kLongest; };
    const int side = std::clamp(std::max(divided(first.size.x, across), divided(first.size.y, down)), 1,
                                std::min(first.size.x, first.size.y));
    const glm::ivec2 cell = first.size / side;
    Image sheet = make_image({across * (cell.x + kGap) - kGap, down * (cell.y + kGap) - kGap});
    std::ranges::fill(sheet.rgba, kGapGrey);
    for (std::size_t i = 3; i < sheet.rgba.size(); i += 4) sheet.rgba[i] = 255;
    for (std::size_t i = 0; i < count; ++i) {
        const auto column = static_cast<int>(i % columns), row = static_cast<int>(i / columns);
        put_shrunk(i == 0 ? first : picture(i), side, {column * (cell.x + kGap), row * (cell.y + kGap)}, sheet);
    }
    return sheet;
}

}  // namespace normalscope

#include "commands/contact_sheet.h"

#include "core/image/shrunk.h"

#include <algorithm>

namespace normalscope {

namespace {

constexpr int kLongest = 2560, kGap = 4;
constexpr std::uint8_t kGapGrey = 128;

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
        const Image small = shrunk_by(i == 0 ? first : picture(i), side);
        for (int y = 0; y < cell.y; ++y)
            std::copy_n(small.pixel(0, y), 4 * cell.x,
                        sheet.pixel(column * (cell.x + kGap), row * (cell.y + kGap) + y));
    }
    return sheet;
}

}  // namespace normalscope

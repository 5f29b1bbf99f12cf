#include "ui/kit/drawn_letters.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace normalscope {

bool DrawnLetters::add(std::span<const char32_t> letters) {
    letters_.insert(letters.begin(), letters.end());
    return draw_ && !letters_.empty();
}

void DrawnLetters::reserve(ImFontAtlas& atlas, ImFont* font, float em, float ascent) {
    if (!draw_) return;
    for (const char32_t letter : letters_) {
        std::optional<LetterPicture> picture = draw_(letter, em);
        if (!picture) continue;
        const int rect = atlas.AddCustomRectFontGlyph(font, letter, picture->width, picture->height, picture->advance,
                                                      {picture->left, ascent - picture->above});
        reserved_.push_back({rect, std::move(*picture)});
    }
}

void DrawnLetters::place(ImFontAtlas& atlas) {
    unsigned char* pixels = nullptr;
    int width = 0;
    if (!reserved_.empty()) atlas.GetTexDataAsAlpha8(&pixels, &width, nullptr);
    for (const auto& [number, picture] : std::exchange(reserved_, {})) {
        const ImFontAtlasCustomRect* rect = atlas.GetCustomRectByIndex(number);
        for (int y = 0; y < picture.height; ++y)
            std::copy_n(picture.cover.data() + static_cast<std::ptrdiff_t>(y) * picture.width, picture.width,
                        pixels + static_cast<std::ptrdiff_t>(rect->Y + y) * width + rect->X);
    }
}

}  // namespace normalscope

#include "platform/known_fonts.h"
#include "platform/system_fonts.h"

#include <array>

namespace normalscope {

namespace {

constexpr std::array<KnownFont, 9> kKnown{{{"Supplemental/Arial Unicode.ttf", 0x0080, 0x10ff},
                                           {"AppleSDGothicNeo.ttc", 0x1100, 0x11ff},
                                           {"Supplemental/Arial Unicode.ttf", 0x1e00, 0x20ff},
                                           {"Apple Symbols.ttf", 0x2100, 0x2bff},
                                           {"Hiragino Sans GB.ttc", 0x3000, 0x9fff},
                                           {"Supplemental/Arial Unicode.ttf", 0x3000, 0x9fff},
                                           {"AppleSDGothicNeo.ttc", 0xac00, 0xd7af},
                                           {"Supplemental/Arial Unicode.ttf", 0xf900, 0xffef},
                                           {"Apple Symbols.ttf", 0x10000, 0x1ffff}}};

}  // namespace

std::vector<FontFile> system_fonts(std::span<const char32_t> letters) {
    return known_fonts("/System/Library/Fonts", kKnown, letters);
}

}  // namespace normalscope

#include "core/base/system.h"
#include "platform/known_fonts.h"
#include "platform/system_fonts.h"

#include <array>

namespace normalscope {

namespace {

constexpr std::array<KnownFont, 14> kKnown{{{"segoeui.ttf", 0x0080, 0x08ff},
                                            {"Nirmala.ttc", 0x0900, 0x0dff},
                                            {"Nirmala.ttf", 0x0900, 0x0dff},
                                            {"LeelawUI.ttf", 0x0e00, 0x0eff},
                                            {"segoeui.ttf", 0x10a0, 0x10ff},
                                            {"malgun.ttf", 0x1100, 0x11ff},
                                            {"segoeui.ttf", 0x1e00, 0x20ff},
                                            {"seguisym.ttf", 0x2100, 0x2bff},
                                            {"YuGothR.ttc", 0x3000, 0x30ff},
                                            {"msyh.ttc", 0x3000, 0x9fff},
                                            {"YuGothR.ttc", 0x3400, 0x9fff},
                                            {"malgun.ttf", 0xac00, 0xd7af},
                                            {"msyh.ttc", 0xf900, 0xffef},
                                            {"seguisym.ttf", 0x10000, 0x1ffff}}};

}  // namespace

std::vector<FontFile> system_fonts(std::span<const char32_t> letters) {
    return known_fonts(std::filesystem::path(variable("SystemRoot")) / "Fonts", kKnown, letters);
}

}  // namespace normalscope

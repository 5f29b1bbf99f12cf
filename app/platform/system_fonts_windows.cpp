#include "platform/system_fonts.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/system.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace normalscope {

namespace {

constexpr std::size_t kLargestFont = std::size_t{128} << 20;

// Fonts that Windows brings, and the letters that they are taken for; where two have some, the first one gives them.
struct Known {
    const char* file;
    char32_t first, last;
};
constexpr std::array<Known, 14> kKnown{{{"segoeui.ttf", 0x0080, 0x08ff},
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
    const std::filesystem::path folder = std::filesystem::path(variable("SystemRoot")) / "Fonts";
    std::vector<FontFile> fonts;
    std::vector<std::string_view> taken;
    for (const Known& font : kKnown) {
        const auto is_for = [&](char32_t letter) { return letter >= font.first && letter <= font.last; };
        if (std::ranges::none_of(letters, is_for) || std::ranges::count(taken, font.file) > 0) continue;
        try {
            fonts.push_back({read_file(folder / font.file, kLargestFont), 0});
            taken.emplace_back(font.file);
        } catch (const Error&) {  // not every Windows brings each
        }
    }
    return fonts;
}

}  // namespace normalscope

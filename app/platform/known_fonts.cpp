#include "platform/known_fonts.h"

#include "core/base/error.h"
#include "core/base/file.h"

#include <algorithm>
#include <string_view>

namespace normalscope {

std::vector<FontFile> known_fonts(const std::filesystem::path& folder, std::span<const KnownFont> known,
                                  std::span<const char32_t> letters) {
    constexpr std::size_t kLargestFont = std::size_t{128} << 20;
    std::vector<FontFile> fonts;
    std::vector<std::string_view> taken;
    for (const KnownFont& font : known) {
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

#include "ui/kit/font_tables.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace normalscope {

namespace {

// The OpenType specification, "The OpenType font file": a table directory of 12 bytes, then 16 for each table.
class Tables {
public:
    explicit Tables(const FontFile& font) : bytes_(font.bytes) {
        if (bytes_.starts_with("ttcf")) directory_ = u32(12 + 4 * static_cast<std::size_t>(font.face));
    }

    struct Table {
        std::size_t at = 0, length = 0;
    };
    /// Empty where there is no such table, or where the file ends before it does.
    std::optional<Table> table(std::string_view tag) const {
        for (std::size_t i = 0; i < u16(directory_ + 4); ++i) {
            const std::size_t entry = directory_ + 12 + 16 * i;
            if (entry + 16 > bytes_.size() || bytes_.substr(entry, 4) != tag) continue;
            const Table found{u32(entry + 8), u32(entry + 12)};
            if (found.at <= bytes_.size() && found.length <= bytes_.size() - found.at) return found;
        }
        return std::nullopt;
    }
    bool has(std::string_view tag) const { return table(tag).has_value(); }

    std::uint16_t u16(std::size_t at) const { return static_cast<std::uint16_t>(byte(at) << 8 | byte(at + 1)); }
    std::int16_t i16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }

private:
    std::uint32_t byte(std::size_t at) const { return at < bytes_.size() ? static_cast<unsigned char>(bytes_[at]) : 0; }
    std::uint32_t u32(std::size_t at) const { return static_cast<std::uint32_t>(u16(at)) << 16 | u16(at + 2); }

    std::string_view bytes_;
    std::size_t directory_ = 0;
};

}  // namespace

std::optional<float> height_in_ems(const FontFile& font) {
    const Tables tables(font);
    constexpr std::array kNeeded{"cmap", "hmtx", "maxp"};
    const bool outlines = (tables.has("glyf") && tables.has("loca")) || tables.has("CFF ");
    const auto head = tables.table("head"), hhea = tables.table("hhea");
    if (!outlines || !head || !hhea || !std::ranges::all_of(kNeeded, [&](auto tag) { return tables.has(tag); }))
        return std::nullopt;
    const int em = tables.u16(head->at + 18), ascent = tables.i16(hhea->at + 4), descent = tables.i16(hhea->at + 6);
    if (em == 0 || ascent - descent <= 0) return std::nullopt;
    return static_cast<float>(ascent - descent) / static_cast<float>(em);
}

}  // namespace normalscope

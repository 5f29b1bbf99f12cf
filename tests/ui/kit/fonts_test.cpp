#include "ui/kit/fonts.h"
#include "ui/kit/font_tables.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace normalscope {
namespace {

std::string big_endian(std::size_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
}

/// Tables of zeros, but for an em of 1000 units, an ascent of 900 and a descent of -300.
FontFile font_with(const std::vector<std::string>& tags) {
    constexpr std::size_t kLength = 64;
    std::string table(kLength, '\0');
    table.replace(18, 2, big_endian(1000, 2));
    table.replace(4, 4, big_endian(900, 2) + big_endian(0x10000 - 300, 2));
    std::string directory = big_endian(0x10000, 4) + big_endian(tags.size(), 2) + std::string(6, '\0'), tables;
    for (const std::string& tag : tags) {
        directory +=
            tag + std::string(4, '\0') + big_endian(12 + 16 * tags.size() + tables.size(), 4) + big_endian(kLength, 4);
        tables += table;
    }
    return {directory + tables, 0};
}

TEST(SystemFonts, AreMeasuredByTheEm) {
    const FontFile font = font_with({"cmap", "head", "hhea", "hmtx", "maxp", "loca", "glyf"});
    EXPECT_FLOAT_EQ(height_in_ems(font).value(), 1.2f);
    for (std::size_t size = 0; size < font.bytes.size(); ++size)
        EXPECT_FALSE(height_in_ems({font.bytes.substr(0, size), 0})) << size;
}

TEST(SystemFonts, AreLeftOutWhereTheyCannotBeRead) {
    for (const std::string outlines : {"CBDT", "CFF2", "SVG "})
        EXPECT_FALSE(height_in_ems(font_with({"cmap", "head", "hhea", "hmtx", "maxp", outlines}))) << outlines;
    EXPECT_FALSE(height_in_ems({"ttcf", 7}));

    ImGui::CreateContext();
    ExtraLetters letters;
    std::vector<std::u32string> asked;
    letters.find_by([&](std::span<const char32_t> wanted) {
        asked.emplace_back(wanted.begin(), wanted.end());
        return std::vector<FontFile>{{"no font", 0}};
    });
    Fonts fonts = build_fonts(1, letters);
    letters.want("法線 ж", fonts.body);
    EXPECT_TRUE(letters.pending());
    fonts = build_fonts(1, letters);
    EXPECT_TRUE(fonts.body->FindGlyphNoFallback(U'ж'));  // the program's own
    EXPECT_FALSE(fonts.body->FindGlyphNoFallback(U'法'));
    fonts = build_fonts(2, letters);
    EXPECT_EQ(asked, (std::vector<std::u32string>{U"法線"}));  // once, whatever came of it
    ImGui::DestroyContext();
}

TEST(SystemFonts, OrTheirLettersAreDrawn) {
    ImGui::CreateContext();
    ExtraLetters letters;
    letters.draw_by([](char32_t, float em) {
        return LetterPicture{.width = 2, .height = 1, .cover = {7, 77}, .left = 1, .above = 12, .advance = em};
    });
    Fonts fonts = build_fonts(2, letters);
    letters.want("法", fonts.body);
    fonts = build_fonts(2, letters);
    const ImFontGlyph* glyph = fonts.body->FindGlyphNoFallback(U'法');
    ASSERT_TRUE(glyph);
    EXPECT_FLOAT_EQ(glyph->AdvanceX, 30);  // of 15, at a scale of 2
    EXPECT_NEAR(glyph->Y0, fonts.body->Ascent - 12, 1.0f);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    const auto x = static_cast<int>(std::lround(glyph->U0 * static_cast<float>(width)));
    const auto y = static_cast<int>(std::lround(glyph->V0 * static_cast<float>(height)));
    EXPECT_EQ((std::vector<int>{pixels[y * width + x], pixels[y * width + x + 1]}), (std::vector<int>{7, 77}));
    ImGui::DestroyContext();
}

TEST(ExtraLetters, AreInHeadings) {
    ImGui::CreateContext();
    ExtraLetters letters;
    Fonts fonts = build_fonts(1, letters);
    EXPECT_FALSE(fonts.title->FindGlyphNoFallback(U'\u2202')) << "the test needs another letter";
    letters.want("\u2202f/\u2202y: \u00fcber", fonts.title);
    fonts = build_fonts(1, letters);
    for (const ImFont* font : {fonts.title, fonts.strong, fonts.body})
        for (const ImWchar letter : {U'\u2202', U'\u00fc'}) EXPECT_TRUE(font->FindGlyphNoFallback(letter)) << letter;
    ImGui::DestroyContext();
}

}  // namespace
}  // namespace normalscope

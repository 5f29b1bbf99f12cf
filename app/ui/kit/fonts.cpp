#include "ui/kit/fonts.h"

#include "ui/kit/font_tables.h"
#include "ui/kit/previews.h"

#include <embedded.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace normalscope {

namespace {

// Pairs of first and last, ended by 0.
// From Open Sans: Latin-1's marks and letters, dashes, quotes, the ellipsis and the minus sign. Not ¹ ² ³: superscripts
// come from one font, so that those of (M⁻¹)ᵀ match.
constexpr std::array<ImWchar, 15> kLatin{0x20,   0x7E,   0xA0,   0xB1,   0xB4,   0xB8,   0xBA, 0xFF,
                                         0x2013, 0x201D, 0x2026, 0x2026, 0x2212, 0x2212, 0};
constexpr std::array<ImWchar, 17> kLatinFew{0x20, 0x7E,   0xB0,   0xB1,   0xB7,   0xB7,   0xBA,   0xBE, 0xD7,
                                            0xD7, 0x2014, 0x2019, 0x2026, 0x2026, 0x2212, 0x2212, 0};
// From DejaVu Sans: super- and subscripts, Greek, arrows, operators, marks.
constexpr std::array<ImWchar, 35> kMath{0xB2,   0xB3,   0xB9,   0xB9,   0x3B8,  0x3B8,  0x3BA,  0x3BB,  0x3C0,
                                        0x3C0,  0x3C3,  0x3C3,  0x1D40, 0x1D40, 0x1D56, 0x1D56, 0x2032, 0x2032,
                                        0x207B, 0x207B, 0x2080, 0x2084, 0x2190, 0x2194, 0x2202, 0x2207, 0x2218,
                                        0x221E, 0x2248, 0x2265, 0x2713, 0x2717, 0x22A5, 0x22A5, 0};
constexpr std::array<ImWchar, 21> kMathFew{0xB2,   0xB3,   0xB9,   0xB9,   0x3C3,  0x3C3,  0x1D40,
                                           0x1D40, 0x1D56, 0x1D56, 0x207B, 0x207B, 0x2080, 0x2083,
                                           0x2207, 0x2207, 0x2260, 0x2260, 0x22A5, 0x22A5, 0};

// From DejaVu Sans, beside the digits of equations: π, ∂, ∇.
constexpr std::array<ImWchar, 7> kSigns{0x3C0, 0x3C0, 0x2202, 0x2202, 0x2207, 0x2207, 0};

constexpr std::array<ImWchar, 5> kLetters{'A', 'Z', 'a', 'z', 0};
constexpr std::array<ImWchar, 11> kDigits{0x20, 0x7E, 0xB0, 0xB0, 0xB7, 0xB7, 0x2014, 0x2014, 0x2212, 0x2212, 0};

// Dear ImGui measures a font from its highest ascender to its lowest descender; people, and these sizes, by the em.
struct Face {
    const char* file;
    float height;  ///< ascent and descent, in ems
};
constexpr Face kRegular{"fonts/OpenSans-Regular.ttf", 1.362f};
constexpr float kAscent = 0.785f;  // of that height, above the baseline
constexpr Face kSemibold{"fonts/OpenSans-Semibold.ttf", 1.362f};
constexpr Face kSlanted{"fonts/OpenSans-SemiboldItalic.ttf", 1.362f};
constexpr Face kSymbols{"fonts/DejaVuSans.ttf", 1.164f};
constexpr float kBodySize = 15.0f;
constexpr float kSymbolsSize = 0.94f;  // its letters are larger in the same em

class Baker {
public:
    explicit Baker(float scale) : scale_{scale}, atlas_{*ImGui::GetIO().Fonts} {}

    ImFont* add(const Face& face, float em, const ImWchar* letters) { return load(face, em, letters, nullptr); }
    void merge(const Face& face, float em, const ImWchar* letters, ImFont* into) { load(face, em, letters, into); }
    void merge(const FontFile& font, float em, const ImWchar* letters) {
        if (const auto height = height_in_ems(font)) load(font.bytes, font.face, em * *height, letters, true);
    }

private:
    ImFont* load(const Face& face, float em, const ImWchar* letters, const ImFont* into) {
        const auto data = embedded::file(face.file);
        if (!data) return into ? nullptr : atlas_.AddFontDefault();
        return load(*data, 0, em * face.height, letters, into != nullptr);
    }
    ImFont* load(std::string_view data, int face, float height, const ImWchar* letters, bool into_last) {
        ImFontConfig config;
        config.FontNo = face;
        config.FontDataOwnedByAtlas = false;
        config.MergeMode = into_last;
        // Glyphs on whole pixels need no oversampling: sharp, a quarter of the texture, and baked in half the time.
        config.OversampleH = 1;
        config.PixelSnapH = true;
        config.GlyphRanges = letters;
        // The atlas only reads what it does not own, but takes no pointer to const.
        return atlas_.AddFontFromMemoryTTF(const_cast<char*>(data.data()), static_cast<int>(data.size()),
                                           std::round(height * scale_), &config);
    }

    float scale_;
    ImFontAtlas& atlas_;
};

std::vector<ImWchar> as_ranges(const std::set<ImWchar>& letters) {
    std::vector<ImWchar> ranges;
    for (const ImWchar letter : letters) ranges.insert(ranges.end(), {letter, letter});
    ranges.push_back(0);
    return ranges;
}

}  // namespace

void ExtraLetters::want(std::string_view utf8, const ImFont* font) {
    for (std::size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<unsigned char>(utf8[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        ImWchar letter = length == 1 ? lead : lead & (0xFFu >> (length + 1));
        bool valid = lead < 0x80 || lead >= 0xC2;
        for (std::size_t k = 1; k < length; ++k) {
            const unsigned char next = i + k < utf8.size() ? static_cast<unsigned char>(utf8[i + k]) : 0;
            valid &= (next & 0xC0) == 0x80;
            letter = letter << 6 | (next & 0x3Fu);
        }
        i += valid ? length : 1;
        if (!valid || letter < 0xA0 || letter > 0x10FFFF || font->FindGlyphNoFallback(letter)) continue;
        if (letters_.insert(letter).second) pending_ = true;
    }
}

bool ExtraLetters::find_more(const ImFont* font) {
    std::vector<char32_t> missing;
    for (const ImWchar letter : letters_)
        if (!font->FindGlyphNoFallback(letter) && asked_.insert(letter).second) missing.push_back(letter);
    if (missing.empty()) return false;
    std::vector<FontFile> fonts = find_ ? find_(missing) : std::vector<FontFile>();
    std::ranges::move(fonts, std::back_inserter(found_));
    return !fonts.empty() || drawn_.add(missing);
}

Fonts build_fonts(float scale, ExtraLetters& extra, Previews* previews, bool captions) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight | ImFontAtlasFlags_NoMouseCursors;
    const std::vector<ImWchar> letters = as_ranges(extra.all());  // must live until Build

    Baker baker(scale);
    const auto both = [&](const Face& latin, float em, const ImWchar* latin_letters, const ImWchar* math) {
        ImFont* font = baker.add(latin, em, latin_letters);
        baker.merge(kSymbols, em * kSymbolsSize, math, font);
        return font;
    };
    Fonts fonts;
    const auto with_extra = [&](const Face& face, float em, const ImWchar* latin, const ImWchar* math) {
        ImFont* font = both(face, em, latin, math);
        if (letters.size() > 1) {
            baker.merge(face, em, letters.data(), font);
            baker.merge(kSymbols, em * kSymbolsSize, letters.data(), font);
            for (const FontFile& found : extra.found()) baker.merge(found, em, letters.data());
            extra.drawn().reserve(atlas, font, em * scale, std::round(em * face.height * scale) * kAscent);
        }
        return font;
    };
    const auto all = [&](float em) { return with_extra(kRegular, em, kLatin.data(), kMath.data()); };
    const auto few = [&](float em) { return with_extra(kSemibold, em, kLatinFew.data(), kMathFew.data()); };
    fonts.body = all(kBodySize);
    fonts.small = all(13.0f);
    fonts.strong = few(kBodySize);
    fonts.title = few(20.0f);
    fonts.letters = baker.add(kSlanted, 20.0f, kLetters.data());
    fonts.upright = baker.add(kRegular, 20.0f, kDigits.data());
    baker.merge(kSymbols, 20.0f * kSymbolsSize, kSigns.data(), fonts.upright);
    fonts.numbers = baker.add(kRegular, 14.0f, kDigits.data());
    fonts.tiny = baker.add(kRegular, 10.0f, kDigits.data());
    if (captions) {
        fonts.caption_letters = baker.add(kSlanted, 19.0f, kLetters.data());
        fonts.equation_letters = baker.add(kSlanted, 25.0f, kLetters.data());
        fonts.caption = all(19.0f);
        fonts.equation = all(25.0f);
    }
    ImGui::GetIO().FontDefault = fonts.body;
    if (previews) previews->reserve(atlas);
    atlas.Build();
    extra.drawn().place(atlas);
    if (previews) previews->place(atlas);
    extra.built();
    return extra.find_more(fonts.body) ? build_fonts(scale, extra, previews, captions) : fonts;
}

}  // namespace normalscope

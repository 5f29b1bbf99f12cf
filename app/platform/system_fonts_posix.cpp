#include "platform/system_fonts.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "platform/shared_library.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>

namespace normalscope {

namespace {

constexpr std::size_t kLargestFont = std::size_t{128} << 20, kMostFonts = 12;

// Fontconfig's own types and constants, of which only what is called here is needed: no build asks for its headers.
struct Config;
struct Pattern;
struct CharSet;
constexpr int kForPatterns = 0, kFound = 0;

class Fontconfig {
public:
    /// Throws ContextError where it is not installed.
    Fontconfig() : library_({"libfontconfig.so.1"}), config_(function<Config*()>("FcInitLoadConfigAndFonts")()) {
        if (!config_) throw ContextError("fontconfig has no configuration");
    }

    struct Match {
        FontFile font;
        std::vector<char32_t> letters;  ///< those of the wanted ones that it has
    };
    /// The best font for the first of the letters. Empty where none has it.
    std::optional<Match> match(std::span<const char32_t> wanted) const {
        const Owned<CharSet> letters(function<CharSet*()>("FcCharSetCreate")(),
                                     function<void(CharSet*)>("FcCharSetDestroy"));
        function<int(CharSet*, char32_t)>("FcCharSetAddChar")(letters.get(), wanted.front());
        const Owned<Pattern> pattern = owned(function<Pattern*()>("FcPatternCreate")());
        function<int(Pattern*, const char*, const CharSet*)>("FcPatternAddCharSet")(pattern.get(), "charset",
                                                                                    letters.get());
        function<int(Pattern*, const char*, const char*)>("FcPatternAddString")(pattern.get(), "family", "sans-serif");
        const auto add_bool = function<int(Pattern*, const char*, int)>("FcPatternAddBool");
        add_bool(pattern.get(), "outline", 1);
        add_bool(pattern.get(), "color", 0);
        function<int(Config*, Pattern*, int)>("FcConfigSubstitute")(config_, pattern.get(), kForPatterns);
        function<void(Pattern*)>("FcDefaultSubstitute")(pattern.get());
        int result = kFound;
        const Owned<Pattern> best =
            owned(function<Pattern*(Config*, Pattern*, int*)>("FcFontMatch")(config_, pattern.get(), &result));
        if (!best || !is_readable(*best)) return std::nullopt;
        return found(*best, wanted);
    }

private:
    template <class T>
    using Owned = std::unique_ptr<T, void (*)(T*)>;
    template <class F>
    F* function(const char* name) const {
        return library_.function<F>(name);
    }
    Owned<Pattern> owned(Pattern* pattern) const { return {pattern, function<void(Pattern*)>("FcPatternDestroy")}; }

    std::string text(Pattern& font, const char* key) const {
        const char* value = nullptr;
        const auto get = function<int(Pattern*, const char*, int, const char**)>("FcPatternGetString");
        return get(&font, key, 0, &value) == kFound && value ? value : "";
    }
    // Outlines of a kind that Dear ImGui reads.
    bool is_readable(Pattern& font) const {
        int outline = 0;
        const auto get = function<int(Pattern*, const char*, int, int*)>("FcPatternGetBool");
        const std::string format = text(font, "fontformat");
        return get(&font, "outline", 0, &outline) == kFound && outline && (format == "TrueType" || format == "CFF");
    }
    std::optional<Match> found(Pattern& font, std::span<const char32_t> wanted) const {
        CharSet* has = nullptr;  // the font's own
        if (function<int(Pattern*, const char*, int, CharSet**)>("FcPatternGetCharSet")(&font, "charset", 0, &has) !=
            kFound)
            return std::nullopt;
        const auto has_letter = function<int(const CharSet*, char32_t)>("FcCharSetHasChar");
        Match match;
        for (const char32_t letter : wanted)
            if (has_letter(has, letter)) match.letters.push_back(letter);
        if (match.letters.empty() || match.letters.front() != wanted.front()) return std::nullopt;
        int face = 0;
        function<int(Pattern*, const char*, int, int*)>("FcPatternGetInteger")(&font, "index", 0, &face);
        match.font = {read_file(text(font, "file"), kLargestFont), face & 0xffff};  // above: a variable font's instance
        return match;
    }

    SharedLibrary library_;
    Config* config_;  // never freed: there is one as long as the program runs
};

const Fontconfig* fontconfig() {
    static const std::unique_ptr<const Fontconfig> one = [] {
        try {
            return std::make_unique<const Fontconfig>();
        } catch (const ContextError&) {
            return std::unique_ptr<const Fontconfig>();
        }
    }();
    return one.get();
}

}  // namespace

std::vector<FontFile> system_fonts(std::span<const char32_t> letters) {
    std::vector<FontFile> fonts;
    const Fontconfig* const config = fontconfig();
    std::vector<char32_t> wanted(letters.begin(), letters.end());
    while (config && !wanted.empty() && fonts.size() < kMostFonts) {
        std::vector<char32_t> given{wanted.front()};  // up, where no font has it
        try {
            if (auto match = config->match(wanted)) {
                fonts.push_back(std::move(match->font));
                given = std::move(match->letters);
            }
        } catch (const Error&) {  // a font that cannot be read, or another fontconfig than is known
        }
        std::erase_if(wanted, [&](char32_t letter) { return std::ranges::find(given, letter) != given.end(); });
    }
    return fonts;
}

}  // namespace normalscope

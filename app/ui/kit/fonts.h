#pragma once

#include "core/base/font_file.h"
#include "ui/kit/drawn_letters.h"

#include <imgui.h>

#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace normalscope {

class Previews;

struct Fonts {
    ImFont* body = nullptr;     ///< 15 px
    ImFont* small = nullptr;    ///< 13 px: what stands beside, and tables
    ImFont* strong = nullptr;   ///< 15 px, semibold: headings
    ImFont* title = nullptr;    ///< 20 px, semibold: the words on the picture, the rules' formulas
    ImFont* letters = nullptr;  ///< 20 px, slanted: the letters of equations, and no other signs
    ImFont* upright = nullptr;  ///< 20 px: the digits and operators beside them
    ImFont* numbers = nullptr;  ///< 14 px: the entries of their matrices
    ImFont* tiny = nullptr;     ///< 10 px: what stands above and below the letters of small words
    // What is said below the picture, in a lesson or a lecture; baked where it is wanted.
    ImFont* caption = nullptr;                                       ///< 19 px
    ImFont* equation = nullptr;                                      ///< 25 px
    ImFont *caption_letters = nullptr, *equation_letters = nullptr;  ///< the same sizes, slanted: names of one letter
};

/// Letters beyond those that the interface itself uses: those of file names, messages, lessons and scenes' sentences. Baking every letter of
/// every script at the start would cost more than all else that the interface does.
class ExtraLetters {
public:
    /// Remembers the letters of this text that `font` lacks.
    void want(std::string_view utf8, const ImFont* font);
    /// There are some that no atlas has been built with yet.
    bool pending() const { return pending_; }

    const std::set<ImWchar>& all() const { return letters_; }
    void built() { pending_ = false; }

    /// Who has fonts for letters that the program's own lack. Without, these are shown as question marks.
    void find_by(FindFonts find) { find_ = std::move(find); }
    void draw_by(DrawLetter draw) { drawn_.draw_by(std::move(draw)); }
    /// Asks for the letters that `font` lacks even now, each once. Whether there is another font for them, or who draws them.
    bool find_more(const ImFont* font);
    const std::vector<FontFile>& found() const { return found_; }
    DrawnLetters& drawn() { return drawn_; }

private:
    std::set<ImWchar> letters_, asked_;
    bool pending_ = false;
    FindFonts find_;
    std::vector<FontFile> found_;
    DrawnLetters drawn_;
};

/// Makes the current context's font atlas anew and bakes it, with room for the previews that are wanted. `captions`: with
/// the fonts of what is said below the picture.
Fonts build_fonts(float scale, ExtraLetters& extra, Previews* previews = nullptr, bool captions = false);

}  // namespace normalscope

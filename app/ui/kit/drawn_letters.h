#pragma once

#include "core/base/letter_picture.h"

#include <imgui.h>

#include <set>
#include <span>
#include <vector>

namespace normalscope {

/// Letters that no font file has, in the font atlas: drawn by whoever has fonts, but not as files.
class DrawnLetters {
public:
    void draw_by(DrawLetter draw) { draw_ = std::move(draw); }
    /// These are to be drawn. Whether there is anyone who draws.
    bool add(std::span<const char32_t> letters);
    /// Before the atlas is built: into a font whose em has so many pixels, and whose lines' tops are so far above the
    /// baseline.
    void reserve(ImFontAtlas& atlas, ImFont* font, float em, float ascent);
    /// After that.
    void place(ImFontAtlas& atlas);

private:
    struct Reserved {
        int rect;
        LetterPicture picture;
    };
    DrawLetter draw_;
    std::set<char32_t> letters_;
    std::vector<Reserved> reserved_;
};

}  // namespace normalscope

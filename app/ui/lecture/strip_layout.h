#pragma once

#include "ui/kit/style.h"
#include "ui/lecture/speech.h"
#include "ui/typeset/math_box.h"

#include <cstddef>
#include <span>
#include <vector>

namespace normalscope {

inline constexpr float kStripPad = 20.0f, kStripHeader = 34.0f, kStripGap = 7.0f, kStripBottom = 12.0f;

/// Where the words stand, and how much of the window they take: of its height, or of its width.
struct StripPlace {
    enum class Side { Below, Beside } side = Side::Below;
    float takes = 0.0f;
};

/// In a strip of that size, what stands where, from its top left: the words, and the board below or beside them.
struct StripRooms {
    ImVec2 words_low, words_size, board_low, board_size;
};
StripRooms strip_rooms(const Look& look, const Speech& speech, StripPlace::Side side, ImVec2 size);

/// How high a strip of that width must be for all of it, with what is new on the board.
float strip_height(const Look& look, const Speech& speech, StripPlace::Side side, float width);

/// The same with its question no larger than notes, where that is too much for a strip in that room.
Speech fitted(const Look& look, Speech speech, StripPlace::Side side, float width, ImVec2 room);

/// The look in which all words of the speech fit into a strip in that room, so that nobody need scroll: with smaller letters,
/// down to a limit.
Look fitting_look(const Look& look, const Speech& speech, StripPlace::Side side, float width, ImVec2 room);

/// On the side that leaves the objects of these steps the larger picture, for the whole lesson: nobody's eyes are to jump.
/// As high as `held` at most needs, but no higher than half of the room.
StripPlace strip_place(const Look& look, std::span<const Speech> lesson, std::span<const Speech> held, ImVec2 room);

MathBox caption_box(const Look& look, const Speech& speech, float width);
MathBox note_box(const Look& look, std::string_view text, float width, Ink ink);
/// Sets a question off from a caption of its own size.
float above_question(const Look& look, const Speech& speech);
/// The question itself, or what is said of an answer.
MathBox question_box(const Look& look, const Speech& speech, std::string_view text, float width, Ink ink);

/// A question's choices stand in one or two columns.
std::size_t choice_columns(const Look& look, const Speech& speech, float width);
float choice_width(const Look& look, std::size_t columns, float width);
/// Where its words begin, right of its letter.
float choice_indent(const Look& look, const Speech& speech);
MathBox choice_box(const Look& look, const Speech& speech, const Choice& choice, float width);
std::string verdict(const Choice& choice);

/// The rows of the board, the first at the top: what is new, large, and above it of the earlier ones the last that fit.
std::vector<MathBox> board_rows(const Look& look, const Speech& speech, ImVec2 size);

}  // namespace normalscope

#include "ui/lecture/strip_layout.h"

#include "core/lessons/lesson_board.h"
#include "core/lessons/lesson_limits.h"
#include "ui/typeset/math_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

constexpr float kTwoColumns = 640.0f;   // from this width on, choices stand in two columns
constexpr float kBoardBeside = 600.0f;  // and below a picture the board stands beside the words
constexpr float kWordsShare = 0.56f;    // of the width, then
constexpr float kNarrowest = 290.0f;    // column of words beside a picture: some 27 letters
constexpr std::array kColumns{0.42f, 0.38f, 0.34f, 0.30f, 0.46f, 0.50f};  // of the width
constexpr float kLargestShare = 0.5f;  // more words than this leave too little of the picture
constexpr float kWorthIt = 1.05f;      // a picture that is larger by so much

MathStyle style_with(const Look& look, const ImFont* words, const ImFont* below, const ImFont* letters) {
    MathStyle style = math_style(look);
    style.script = words;
    style.subscript_in_text = below;
    style.letters_in_text = letters;
    return style;
}

// Rather smaller than broken, as long as it can be read.
MathBox equation_box(MathStyle style, std::string_view text, float width, const WordInks& inks) {
    style.formula = true;
    const float usual = style.shrink;
    for (const float shrink : {1.0f, 0.92f, 0.84f, 0.76f, 0.7f, 0.64f}) {
        style.shrink = usual * shrink;
        MathBox box = paragraph(style, text, 1e9f, inks);
        if (box.width <= width) return box;
    }
    MathBox box = paragraph(style, text, width, inks);
    for (; box.width > width && style.shrink > 0.3f; box = paragraph(style, text, width, inks)) style.shrink *= 0.9f;
    return box;
}
MathBox new_row(const Look& look, std::string_view text, float width, const std::string& stands_out) {
    return equation_box(style_with(look, look.fonts.equation, look.fonts.body, look.fonts.equation_letters), text,
                        width, {.stands_out = stands_out});
}
MathBox earlier_row(const Look& look, std::string_view text, float width) {
    return equation_box(style_with(look, look.fonts.caption, look.fonts.small, look.fonts.caption_letters), text, width,
                        {.words = Ink::Dim, .stands_out = "what is new"});  // and not these
}

float height_of(const Look& look, const MathBox& box) { return box.height() + look.px(kStripGap); }

float question_height(const Look& look, const Speech& speech, float width) {
    const Question& question = *speech.question;
    float height = above_question(look, speech), because = 0.0f;
    height += height_of(look, question_box(look, speech, question.text, width, Ink::Plain));
    const std::size_t columns = choice_columns(look, speech, width);
    const float each = choice_width(look, columns, width);
    for (std::size_t i = 0; i < question.choices.size(); i += columns) {
        float row = 0.0f;
        for (std::size_t k = i; k < std::min(i + columns, question.choices.size()); ++k)
            row = std::max(row, choice_box(look, speech, question.choices[k], each).height());
        height += row + look.px(10 + 5);
    }
    for (const Choice& choice : question.choices)
        because = std::max(because, height_of(look, question_box(look, speech, verdict(choice), width, Ink::Good)));
    return height + because;
}

float words_height(const Look& look, const Speech& speech, float width) {
    float height = height_of(look, caption_box(look, speech, width));
    if (!speech.look_at.empty()) height += height_of(look, note_box(look, speech.look_at, width, Ink::Dim));
    if (speech.question) height += question_height(look, speech, width);
    return height;
}

// Of what is new on it alone, or else of the last that stand there: this much it gets in any case. A question needs the room.
float board_height(const Look& look, const Speech& speech, float width) {
    float height = 0.0f;
    for (const std::string& line : speech.equations)
        height += height_of(look, new_row(look, line, width, speech.stands_out));
    if (!speech.equations.empty() || speech.question) return height;
    const std::size_t kept = std::min(speech.earlier.size(), kMostEquations);
    for (const std::string& line : std::span(speech.earlier).last(kept))
        height += height_of(look, earlier_row(look, line, width));
    return height;
}

bool has_board(const Speech& speech) { return !speech.equations.empty() || !speech.earlier.empty(); }

bool board_beside_words(const Look& look, const Speech& speech, StripPlace::Side side, float width) {
    return side == StripPlace::Side::Below && width >= look.px(kBoardBeside) && has_board(speech) && !speech.question;
}
float words_width(const Look& look, float width) { return std::max(width - 2 * look.px(kStripPad), look.px(80)); }

// How high a strip may be.
float most_of(StripPlace::Side side, ImVec2 room) {
    return side == StripPlace::Side::Beside ? room.y : std::floor(kLargestShare * room.y);
}

// Of the object in a picture of that size, by its shorter side.
float object_size(const Speech& speech, float width, float height) {
    return std::min(width / static_cast<float>(speech.panes), height);
}

}  // namespace

Speech speech_of(const Lesson& lesson, std::size_t number) {
    const LessonStep& step = lesson.steps[number];
    const bool both = !step.look_at.empty() && !step.to_try.empty();
    Board board = board_at(lesson, number);
    Speech speech{step.caption, step.look_at + (both ? " " : "") + step.to_try, std::move(board.latest), step.question,
                  std::move(board.earlier)};
    if (step.highlight)
        speech.stands_out = step.highlight->naive ? "n_naive" : std::string(name(step.highlight->symbol));
    if (step.scene.view == ViewMode::Split) speech.panes = 2;
    return speech;
}

MathBox caption_box(const Look& look, const Speech& speech, float width) {
    return paragraph(style_with(look, look.fonts.caption, look.fonts.small, look.fonts.caption_letters), speech.caption,
                     width, {.stands_out = speech.stands_out});
}
MathBox note_box(const Look& look, std::string_view text, float width, Ink ink) {
    return paragraph(style_with(look, look.fonts.body, look.fonts.tiny, nullptr), text, width, {.words = ink});
}

float above_question(const Look& look, const Speech& speech) { return speech.to_a_room ? look.px(kStripGap) : 0.0f; }
MathBox question_box(const Look& look, const Speech& speech, std::string_view text, float width, Ink ink) {
    if (!speech.to_a_room) return note_box(look, text, width, ink);
    return paragraph(style_with(look, look.fonts.caption, look.fonts.small, look.fonts.caption_letters), text, width,
                     {.words = ink});
}

std::size_t choice_columns(const Look& look, const Speech& speech, float width) {
    const std::vector<Choice>& choices = speech.question->choices;
    if (width < look.px(kTwoColumns) || choices.size() < 3) return 1;
    if (!speech.to_a_room) return 2;
    // Letters of that size are for two columns only where no choice is broken by them.
    const float each = choice_width(look, 2, width);
    return std::ranges::all_of(choices,
                               [&](const Choice& choice) {
                                   return choice_box(look, speech, choice, 1e9f).width <=
                                          each - choice_indent(look, speech) - look.px(12);
                               })
               ? 2
               : 1;
}
float choice_width(const Look& look, std::size_t columns, float width) {
    return std::floor((width - static_cast<float>(columns - 1) * look.px(kStripGap)) / static_cast<float>(columns));
}
float choice_indent(const Look& look, const Speech& speech) { return look.px(speech.to_a_room ? 36 : 30); }
MathBox choice_box(const Look& look, const Speech& speech, const Choice& choice, float width) {
    return question_box(look, speech, choice.text, width - choice_indent(look, speech) - look.px(12), Ink::Plain);
}
std::string verdict(const Choice& choice) { return (choice.right ? "✓  " : "✗  ") + choice.because; }

std::vector<MathBox> board_rows(const Look& look, const Speech& speech, ImVec2 size) {
    std::vector<MathBox> rows;
    float left = size.y;
    const auto put = [&](MathBox row) {
        left -= height_of(look, row);
        rows.push_back(std::move(row));
    };
    for (std::size_t i = speech.equations.size(); i-- > 0;)
        put(new_row(look, speech.equations[i], size.x, speech.stands_out));
    for (std::size_t i = speech.earlier.size(); i-- > 0;) {
        MathBox row = earlier_row(look, speech.earlier[i], size.x);
        if (height_of(look, row) > left) break;
        put(std::move(row));
    }
    std::ranges::reverse(rows);
    return rows;
}

StripRooms strip_rooms(const Look& look, const Speech& speech, StripPlace::Side side, ImVec2 size) {
    const float pad = look.px(kStripPad), top = look.px(kStripHeader), width = words_width(look, size.x);
    const float high = std::max(size.y - top - look.px(kStripBottom), 1.0f);
    StripRooms rooms{{pad, top}, {width, high}, {pad, top}, {0, 0}};
    if (!has_board(speech)) return rooms;
    if (board_beside_words(look, speech, side, size.x)) {
        rooms.words_size.x = std::floor(kWordsShare * width);
        rooms.board_low.x = pad + rooms.words_size.x + 2 * pad;
        rooms.board_size = {width - rooms.words_size.x - 2 * pad, high};
        return rooms;
    }
    const float gap = look.px(2 * kStripGap);
    const float board = std::min(board_height(look, speech, width) + gap, high);
    rooms.words_size.y = std::min(words_height(look, speech, width) + look.px(4), high - board);
    rooms.board_low.y = top + rooms.words_size.y + gap;
    rooms.board_size = {width, high - rooms.words_size.y - gap};
    return rooms;
}

float strip_height(const Look& look, const Speech& speech, StripPlace::Side side, float width) {
    const float inside = words_width(look, width), more = look.px(kStripHeader + kStripBottom);
    if (board_beside_words(look, speech, side, width)) {
        const float words = std::floor(kWordsShare * inside);
        return std::ceil(std::max(words_height(look, speech, words),
                                  board_height(look, speech, inside - words - 2 * look.px(kStripPad))) +
                         more);
    }
    const float gap = has_board(speech) ? look.px(2 * kStripGap) : 0.0f;
    return std::ceil(words_height(look, speech, inside) + look.px(4) + gap + board_height(look, speech, inside) + more);
}

Speech fitted(const Look& look, Speech speech, StripPlace::Side side, float width, ImVec2 room) {
    const float most = most_of(side, room);
    if (speech.to_a_room) speech.to_a_room = strip_height(look, speech, side, width) <= most;
    return speech;
}

Look fitting_look(const Look& look, const Speech& speech, StripPlace::Side side, float width, ImVec2 room) {
    const float most = most_of(side, room);
    Look smaller = look;
    for (const float shrink : {1.0f, 0.94f, 0.88f, 0.82f, 0.76f, 0.7f}) {
        smaller.shrink = look.shrink * shrink;
        if (strip_height(smaller, speech, side, width) <= most) break;
    }
    return smaller;
}

StripPlace strip_place(const Look& look, std::span<const Speech> lesson, std::span<const Speech> held, ImVec2 room) {
    using enum StripPlace::Side;
    const float most = std::floor(kLargestShare * room.y);
    const auto height = [&](const Speech& speech, StripPlace::Side side, float width) {
        return strip_height(look, fitted(look, speech, side, width, room), side, width);
    };
    const auto below = [&](const Speech& speech) { return std::min(height(speech, Below, room.x), most); };
    float best = 0.0f;
    for (const Speech& speech : lesson) best += kWorthIt * object_size(speech, room.x, room.y - below(speech));
    StripPlace place;
    for (const float share : kColumns) {
        const float column = std::floor(share * room.x);
        if (column < look.px(kNarrowest)) continue;
        float size = 0.0f;
        bool fits = true;
        for (const Speech& speech : lesson) {
            size += object_size(speech, room.x - column, room.y);
            fits = fits && height(speech, Beside, column) <= room.y;
        }
        if (fits && size > best) best = size, place = {Beside, column};
    }
    if (place.side == Below)
        for (const Speech& speech : held) place.takes = std::max(place.takes, below(speech));
    return place;
}

}  // namespace normalscope

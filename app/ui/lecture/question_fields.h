#pragma once

#include "core/lessons/lesson.h"
#include "core/lessons/lesson_limits.h"
#include "ui/kit/style.h"
#include "ui/lecture/word_field.h"

#include <array>
#include <cstddef>
#include <string>

namespace normalscope {

/// A step's question with its answers, and its notes, to be written. A row that is left empty is no answer.
class QuestionFields {
public:
    void read(const Look& look, const LessonStep& step);
    Typed draw(const Look& look);
    void write_to(LessonStep& step) const;

private:
    struct Row {
        std::string text, because;
        bool empty() const { return text.empty() && because.empty(); }
    };
    std::size_t rows_to_show() const;
    /// Which is the right one: as marked, or else the first.
    std::size_t right_row() const;
    Typed draw_answer(const Look& look, std::size_t i);

    std::string ask_, notes_;
    std::array<Row, kMostChoices> rows_;
    std::size_t right_ = 0;
};

}  // namespace normalscope

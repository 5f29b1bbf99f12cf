#include "core/lessons/lesson_board.h"

#include <algorithm>

namespace normalscope {

Board board_at(const Lesson& lesson, std::size_t step) {
    Board board;
    for (std::size_t i = 0; i <= step && i < lesson.steps.size(); ++i) {
        const LessonStep& now = lesson.steps[i];
        board.earlier.insert(board.earlier.end(), board.latest.begin(), board.latest.end());
        if (now.board == LessonStep::BoardIs::Wiped) board.earlier.clear();
        board.latest = now.equations;
        // Whatever is said again stands where it was said last.
        std::erase_if(board.earlier,
                      [&](const std::string& line) { return std::ranges::count(board.latest, line) > 0; });
    }
    return board;
}

}  // namespace normalscope

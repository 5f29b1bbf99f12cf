#pragma once

#include "core/lessons/lesson.h"

#include <string>
#include <vector>

namespace normalscope {

/// What stands on the board at a step: the lesson's equations so far, each once, the first one first.
struct Board {
    std::vector<std::string> earlier, latest;  ///< `latest`: the step's own
    friend bool operator==(const Board&, const Board&) = default;
};
Board board_at(const Lesson& lesson, std::size_t step);

}  // namespace normalscope

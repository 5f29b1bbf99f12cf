#pragma once

#include "core/lessons/lesson.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// What is said beside the picture: in a lesson, or by a lecturer.
struct Speech {
    std::string caption, look_at;
    std::vector<std::string> equations;  ///< what is new on the board
    std::optional<Question> question;
    std::vector<std::string> earlier{};  ///< what stands on the board already
    std::string stands_out{};            ///< the symbol, such as "n_world", whose arrow does; empty: none
    int panes = 1;                       ///< of the picture, side by side
    bool to_a_room = false;              ///< which votes: its question is as large as the caption, where there is room
    friend bool operator==(const Speech&, const Speech&) = default;
};
Speech speech_of(const Lesson& lesson, std::size_t step);

}  // namespace normalscope

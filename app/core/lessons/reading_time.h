#pragma once

#include "core/lessons/lesson.h"

#include <string_view>

namespace normalscope {

// How long somebody takes who reads a lesson without a teacher, as in a video.

/// At 15 characters a second, as subtitles are read, or about 150 words a minute; 3 s at least.
double seconds_to_read(std::string_view words);

/// For which a step is shown, or, where it asks something, is shown before it is answered: with time to think.
double seconds_of(const LessonStep& step);
/// For which the answer is shown.
double seconds_of_answer(const Question& question);

/// The one of its choices that is right.
std::size_t right_choice(const Question& question);

}  // namespace normalscope

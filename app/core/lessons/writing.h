#pragma once

#include "core/lessons/lesson.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace normalscope {

// A lesson that is being written. Each change gives another lesson, so that those before can be gone back to.

/// What somebody writes, and the step at which they stand. No lesson: nothing is written.
struct Draft {
    std::shared_ptr<const Lesson> lesson;
    std::size_t step = 0;
    friend bool operator==(const Draft&, const Draft&) = default;
};

/// A lesson of one step, without a file.
Lesson new_lesson(const Scene& scene);
/// With another step behind this one.
Lesson with_step_after(Lesson lesson, std::size_t step, const Scene& scene);
/// With both in each other's place.
Lesson with_swapped(Lesson lesson, std::size_t one, std::size_t other);
/// Throws std::out_of_range. The last step of all cannot be taken away.
Lesson without_step(Lesson lesson, std::size_t step);

/// What is still to be written, a line each, such as "step 4 has no words yet": a file has something in its place.
std::vector<std::string> gaps(const Lesson& lesson);

/// The text of the lesson's file, in which each step says what it changes. What the program does not edit is as it was.
std::string lesson_text(const Lesson& lesson, const std::filesystem::path& file);
/// Writes it. Throws InputError, also for a lesson that could not be read back, and where the file holds anything else.
void save_lesson(const Lesson& lesson, const std::filesystem::path& file);

}  // namespace normalscope

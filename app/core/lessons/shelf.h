#pragma once

#include "core/lessons/lesson.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

/// The lessons that a list has to choose from, in the order in which one leads to the next.
struct LessonShelf {
    std::vector<ListedLesson> lessons = built_in_lessons();
    std::vector<std::string> troubles{};  ///< a line for each file that should be a lesson, and cannot be read
};

/// The folders in which somebody keeps lessons of their own: these, and behind them the one in the user's data folder, which may
/// not be there yet. Throws InputError for one of these that is none.
std::vector<std::filesystem::path> lesson_folders(const std::vector<std::string>& given);

/// The built-in lessons, and behind them those of the folders, by the names of their files. Scenes in them are passed over.
LessonShelf lessons_on_shelf(std::span<const std::filesystem::path> folders);

/// Whether both are the name of one lesson: a file has several.
bool same_lesson(const std::string& a, const std::string& b);

}  // namespace normalscope

// The commands that print, and draw nothing.

#include "commands/commands.h"
#include "commands/scene_arguments.h"
#include "core/base/output.h"
#include "core/base/utf8.h"
#include "core/explain/explanation.h"
#include "core/lessons/open.h"
#include "core/lessons/shelf.h"
#include "platform/console.h"

#include <algorithm>
#include <string>

namespace normalscope {

namespace {

int printed(const std::string& text) {
    print(text);
    return 0;
}

// A line each: its name, and what it is about.
template <class List>
int print_list(const List& list) {
    std::size_t width = 0;
    for (const auto& entry : list) width = std::max(width, columns(entry.name) + 2);
    std::string text;
    for (const auto& entry : list) text += padded(entry.name, width) + entry.about + "\n";
    return printed(text);
}

}  // namespace

int run(const ScenesCommand&) { return print_list(built_in_scenes()); }
int run(const LessonsCommand& command) {
    if (!command.files.empty()) return check_lessons(command);
    const LessonShelf shelf = lessons_on_shelf(lesson_folders(command.lesson_folders));
    print_list(shelf.lessons);
    for (const std::string& line : shelf.troubles) tell_error("normalscope: " + in_one_line(line));
    return shelf.troubles.empty() ? 0 : 3;
}
int run(const ExplainCommand& command) {
    return printed(explain(subject_of(command.file, command.settings).scene, command.format));
}
int run(const Printed& command) { return printed(command.text); }

}  // namespace normalscope

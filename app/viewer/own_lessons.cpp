// Lessons that a user has written, or is writing.

#include "core/base/error.h"
#include "core/lessons/shelf.h"
#include "viewer/viewer.h"

#include <utility>

namespace normalscope {

void Viewer::take_lessons_from(std::vector<std::filesystem::path> folders) {
    lesson_folders_ = std::move(folders);
    list_lessons();
}

void Viewer::list_lessons() {
    if (lesson_folders_.empty()) return;
    lecture().shelf = lessons_on_shelf(lesson_folders_);
    const std::vector<std::string>& troubles = lecture().shelf.troubles;
    if (troubles.empty()) return;
    const std::string others = troubles.size() > 1 ? " (and " + std::to_string(troubles.size() - 1) + " more)" : "";
    complain(troubles.front() + others);
}

void Viewer::watch_lesson() {
    if (!lesson_is_watched()) return;
    const std::string& name = document_.file();
    if (watch_.file() != name) watch_.begin(name, host_.now());
    if (!watch_.changed(host_.now())) return;
    wake();
    try {
        Opened opened = open_file(name, document_.scene);
        if (!opened.lesson) throw InputError(name, "is a lesson no more");
        lecture().replace(std::move(opened.lesson), document_.scene);
        gui_.interface.take_back(watch_complaint_);
        gui_.interface.show_note("Read " + std::filesystem::path(name).filename().string() + " again");
    } catch (const Error& e) {
        watch_complaint_ = std::string(e.what()) + "; what you see is the lesson as it was";
        gui_.interface.show_error(watch_complaint_);
    }
}

}  // namespace normalscope

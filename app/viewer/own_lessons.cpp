// Lessons that a user has written, or is writing.

#include "core/base/error.h"
#include "core/lessons/shelf.h"
#include "viewer/viewer.h"

#include <utility>

namespace normalscope {

namespace {

constexpr const char* kChanged = " (changed)";

}  // namespace

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
    if (document_.unsaved_lesson())
        return gui_.interface.show_note("Something else has written to " + name + ": saving would write over it");
    try {
        Opened opened = open_file(name, document_.scene);
        if (!opened.lesson) throw InputError(name, "is no longer a lesson");
        lecture().replace(opened.lesson, document_.scene);
        if (document_.draft.lesson) {
            document_.draft = {opened.lesson, lecture().player.number()};
            document_.lesson_saved_as(name);
        }
        gui_.interface.take_back(watch_complaint_);
        gui_.interface.show_note("Read " + std::filesystem::path(name).filename().string() + " again");
    } catch (const Error& e) {
        watch_complaint_ = std::string(e.what()) + "; what you see is the lesson as it was";
        gui_.interface.show_error(watch_complaint_);
    }
}

void Viewer::write(Writing what) {
    if (what == Writing::Done || exercising() ||
        (what == Writing::ThisLesson && (document_.draft.lesson || !in_lesson())))
        return;
    commit();
    wake();
    if (what == Writing::New) {
        const auto lesson = std::make_shared<const Lesson>(new_lesson(document_.scene));
        document_.write(lesson->name, {lesson, 0}, nullptr);
    } else {
        // A built-in one stays what it is.
        const std::string name = document_.file() + (is_built_in_lesson(document_.file()) ? kChanged : "");
        lecture().player.arrive(document_.scene);
        const Draft draft{lecture().player.shared_lesson(), lecture().player.number()};
        document_.write(name, draft, draft.lesson);
    }
    lecture().follow(document_.draft);
}

void Viewer::write(const Draft& draft) {
    const bool gone = draft.lesson->steps.size() < document_.draft.lesson->steps.size();
    document_.draft = draft;
    lecture().follow(draft);
    if (gone) lecture().press(LectureKey::Again, document_.scene, frame());  // its scene is not the next one's
    wake();
}

void Viewer::follow_draft() {
    LessonPlayer& player = lecture().player;
    const Draft& draft = document_.draft;
    if (draft.lesson)
        lecture().follow(draft);
    else if (player.running() && document_.file() != player.lesson().name)
        lecture().leave(document_.scene);  // it was begun after this
}

void Viewer::ask_save_lesson() {
    std::error_code error;
    const bool has_file = std::filesystem::is_regular_file(document_.file(), error);
    gui_.interface.ask_save_lesson(has_file || lesson_folders_.empty() ? std::filesystem::path()
                                                                       : lesson_folders_.back());
}

void Viewer::save_lesson(const std::filesystem::path& file) {
    if (std::error_code error; !lesson_folders_.empty() && file.parent_path() == lesson_folders_.back())
        std::filesystem::create_directories(lesson_folders_.back(), error);  // writing says what is wrong
    normalscope::save_lesson(*document_.draft.lesson, file);
    document_.lesson_saved_as(file.string());
    watch_.begin(file, host_.now());
    note_file(file);
    host_.saved(file);
    list_lessons();
    std::string note = "Saved " + file.string();
    if (const std::vector<std::string> open = gaps(*document_.draft.lesson); !open.empty()) note += "; " + open.front();
    gui_.interface.show_done(note);
    if (std::exchange(closes_when_saved_, false)) close();
}

}  // namespace normalscope

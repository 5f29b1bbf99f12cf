#include "core/lessons/shelf.h"

#include "core/base/error.h"
#include "core/base/system.h"
#include "core/base/text.h"
#include "core/lessons/open.h"

#include <algorithm>
#include <system_error>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 200;

std::vector<fs::path> json_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (std::error_code ignored;
            in_small_letters(it->path().extension().string()) == ".json" && it->is_regular_file(ignored))
            files.push_back(it->path());
    std::ranges::sort(files);
    if (files.size() > kMostFiles) files.resize(kMostFiles);
    return files;
}

fs::path whole(const fs::path& file) {
    std::error_code ignored;
    return fs::absolute(file, ignored).lexically_normal();
}

}  // namespace

std::vector<fs::path> lesson_folders(const std::vector<std::string>& given) {
    std::vector<fs::path> folders;
    std::error_code ignored;
    for (const std::string& folder : given) {
        if (!fs::is_directory(folder, ignored))
            throw InputError(folder, "is not a folder; --lessons wants one, with lessons of your own in it");
        folders.push_back(whole(folder));
    }
    const fs::path data = data_folder_of("normalscope");
    if (!data.empty()) folders.push_back(data / "lessons");
    return folders;
}

LessonShelf lessons_on_shelf(std::span<const fs::path> folders) {
    LessonShelf shelf;
    for (const fs::path& folder : folders)
        for (const fs::path& file : json_files(folder)) {
            const std::string name = text_of(file);
            try {
                const Contents contents = open_name(name);
                if (const auto* opened = std::get_if<OpenedLesson>(&contents)) {
                    const Lesson& lesson = *opened->lesson;
                    shelf.lessons.push_back({name, lesson.title, lesson.about, lesson.steps.size()});
                }
            } catch (const InputError& e) {
                shelf.troubles.emplace_back(e.what());
            }
        }
    return shelf;
}

bool same_lesson(const std::string& a, const std::string& b) {
    return a == b || (!is_built_in_lesson(a) && !is_built_in_lesson(b) && whole(a) == whole(b));
}

}  // namespace normalscope

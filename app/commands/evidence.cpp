#include "commands/evidence.h"

#include "commands/files_of_run.h"
#include "core/image/png.h"

namespace normalscope {

namespace {

namespace fs = std::filesystem;

fs::path beside(const fs::path& actual_file, const char* what) {
    fs::path file = actual_file;
    return file.replace_filename(actual_file.stem().string() + what);
}

bool is_device(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(file, ignored) && !fs::is_regular_file(file, ignored);
}

}  // namespace

std::vector<fs::path> evidence_files(const fs::path& actual_file, const fs::path& reference) {
    if (is_device(actual_file)) return {};  // not into /dev
    std::vector<fs::path> files{beside(actual_file, ".difference.png")};
    const fs::path copy = beside(actual_file, ".expected.png");
    if (!FilesOfRun::same(copy, reference)) files.push_back(copy);
    return files;
}

std::vector<fs::path> leave_evidence(const fs::path& actual_file, const fs::path& reference, const Image& actual,
                                     const Image& expected, const Tolerance& tolerance) {
    std::vector<fs::path> files = evidence_files(actual_file, reference);
    if (files.size() > 1) write_png(files[1], expected);
    if (too_large_to_show(actual.size, expected.size))
        files.erase(files.begin(), files.begin() + (files.empty() ? 0 : 1));
    else if (!files.empty())
        write_png(files[0], difference_picture(actual, expected, tolerance));
    return files;
}

void remove_evidence(const fs::path& actual_file, const fs::path& reference) {
    std::error_code ignored;
    for (const fs::path& file : evidence_files(actual_file, reference)) fs::remove(file, ignored);
}

}  // namespace normalscope

#include "batch/numbered.h"

#include "core/base/file.h"
#include "core/base/output_names.h"
#include "core/base/text.h"

namespace normalscope {

void make_folders(const std::string& pattern, std::size_t count, std::size_t columns) {
    std::filesystem::path made;
    for (std::size_t i = 0; i < count; ++i) {
        const std::filesystem::path folder = numbered(pattern, i, columns).parent_path();
        if (folder.empty() || folder == made) continue;
        make_folder(folder);
        made = folder;
    }
}

std::string pictures_written(const std::string& pattern, std::size_t count, std::size_t columns) {
    if (is_video(pattern)) return counted(count, "picture") + ": " + pattern;
    const std::string first = numbered(pattern, 0, columns).string(),
                      last = numbered(pattern, count - 1, columns).string();
    return counted(count, "picture") + ": " + first + (first == last ? "" : " to " + last);
}

}  // namespace normalscope

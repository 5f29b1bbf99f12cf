#include "batch/numbered.h"

#include "core/base/file.h"
#include "core/base/text.h"

namespace normalscope {

std::filesystem::path numbered(const std::string& pattern, std::size_t i, std::size_t columns) {
    const bool two = pattern.find('%') != pattern.rfind('%');
    std::string name;
    bool first = true;
    for (std::size_t at = 0; at < pattern.size();) {
        if (pattern[at] != '%') {
            name += pattern[at++];
            continue;
        }
        const std::size_t end = pattern.find('d', at);
        const std::string width = pattern.substr(at + 1, end - at - 1);
        std::string number = std::to_string(!two ? i : first ? i / columns : i % columns);
        const std::size_t digits = width.empty() ? 0 : std::stoul(width);
        if (number.size() < digits) number.insert(0, digits - number.size(), '0');
        name += number;
        first = false;
        at = end + 1;
    }
    return name;
}

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
    const std::string first = numbered(pattern, 0, columns).string(),
                      last = numbered(pattern, count - 1, columns).string();
    return counted(count, "picture") + ": " + first + (first == last ? "" : " to " + last);
}

}  // namespace normalscope

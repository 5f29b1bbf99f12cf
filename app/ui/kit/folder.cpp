#include "ui/kit/folder.h"

#include "core/base/system.h"

#include <algorithm>
#include <cctype>

namespace normalscope {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostEntries = 5000;  // more help nobody, and cost time in every frame

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// The system's reason, without the call that failed.
std::string reason(const std::error_code& error) { return error.message(); }

bool ends_in_one_of(std::span<const std::string_view> endings, const fs::path& file) {
    return endings.empty() || std::ranges::count(endings, lower(shown(file.extension()))) > 0;
}

}  // namespace

std::string shown(const fs::path& path) { return text_of(path); }

Folder read_folder(const fs::path& path, std::span<const std::string_view> endings) {
    Folder result{.path = path, .entries = {}, .error = {}};
    if (path.empty()) {
        for (const fs::path& drive : drives()) result.entries.push_back({text_of(drive), true});
        return result;
    }
    std::error_code error;
    fs::directory_iterator it(path, fs::directory_options::skip_permission_denied, error);
    // skip_permission_denied makes an unreadable folder look like an empty one: ask again.
    if (!error && it == fs::directory_iterator()) (void)fs::directory_iterator(path, error);
    if (error) {
        result.error = shown(path) + ": " + reason(error);
        return result;
    }
    for (; it != fs::directory_iterator(); it.increment(error)) {
        if (error) break;
        const std::string name = shown(it->path().filename());
        if (name.starts_with('.')) continue;
        std::error_code ignored;  // a link into nowhere is no folder
        const bool folder = it->is_directory(ignored);
        if (!folder && !ends_in_one_of(endings, it->path())) continue;
        if (result.entries.size() == kMostEntries) {
            result.cut = true;
            break;
        }
        result.entries.push_back({name, folder});
    }
    if (error) result.error = shown(path) + ": " + reason(error);
    std::ranges::sort(result.entries, [](const FolderEntry& a, const FolderEntry& b) {
        return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
    });
    return result;
}

Folder listed(std::span<const std::string> files, std::span<const std::string_view> endings) {
    Folder result;
    std::error_code ignored;
    for (const std::string& file : files)
        if (ends_in_one_of(endings, file) && fs::is_regular_file(file, ignored)) result.entries.push_back({file});
    return result;
}

fs::path resolved(const std::string& typed, const fs::path& folder) {
    const fs::path path = typed;
    if (typed == "~" || typed.starts_with("~/")) {
        const fs::path home = home_folder();
        if (!home.empty()) return (home / typed.substr(std::min<std::size_t>(2, typed.size()))).lexically_normal();
    }
    return (path.is_absolute() ? path : folder / path).lexically_normal();
}

}  // namespace normalscope

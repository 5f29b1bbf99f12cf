#include "desktop/recovery.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/system.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <system_error>
#include <utility>

namespace normalscope {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kName = "unsaved-", kEnding = ".json";
constexpr std::size_t kMostBytes = std::size_t{1} << 24;

// Whose file it is, if one of these.
std::optional<int> owner(const fs::path& file) {
    const std::string name = file.filename().string();
    if (!name.starts_with(kName) || !name.ends_with(kEnding)) return std::nullopt;
    int id = 0;
    const char *from = name.data() + kName.size(), *to = name.data() + name.size() - kEnding.size();
    const auto [end, error] = std::from_chars(from, to, id);
    return error == std::errc{} && end == to && id > 0 ? std::optional(id) : std::nullopt;
}

// When it was written; long ago where nobody knows.
fs::file_time_type age(const fs::path& file) {
    std::error_code error;
    return fs::last_write_time(file, error);
}

}  // namespace

Recovery::Recovery(std::optional<fs::path> folder) : folder_(std::move(folder)) {
    if (folder_) own_ = *folder_ / (std::string(kName) + std::to_string(process_id()) + std::string(kEnding));
}

std::vector<UnsavedWork> Recovery::left_behind() {
    std::vector<UnsavedWork> found;
    std::error_code error;
    if (!folder_) return found;
    for (const fs::directory_entry& entry : fs::directory_iterator(*folder_, error)) {
        const auto process = owner(entry.path());
        // In a container each process may have the number of the one before.
        if (process && (entry.path() == own_ || !process_runs(*process))) found_.push_back(entry.path());
    }
    std::ranges::sort(found_, {}, age);
    for (const fs::path& file : found_) try {
            std::ranges::move(parse_unsaved(read_file(file, kMostBytes), file.string()), std::back_inserter(found));
        } catch (const Error&) {  // a damaged one is of no use to anyone
        }
    return found;
}

void Recovery::keep(const std::string& unsaved) {
    if (!folder_) return;
    std::error_code error;
    if (unsaved.empty()) {
        fs::remove(*own_, error);
    } else {
        fs::create_directories(*folder_, error);
        try {
            write_file(*own_, unsaved);
        } catch (const Error&) {
            return;
        }
    }
    for (const fs::path& file : std::exchange(found_, {}))
        if (file != own_) fs::remove(file, error);
}

}  // namespace normalscope

#include "desktop/recovery.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/scene/scene_json.h"

#include <signal.h>  // kill
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <system_error>

namespace normalscope {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kName = "unsaved-", kEnding = ".json";
constexpr std::size_t kMostBytes = std::size_t{1} << 24;

// Whose file it is, if one of these.
std::optional<pid_t> owner(const fs::path& file) {
    const std::string name = file.filename().string();
    if (!name.starts_with(kName) || !name.ends_with(kEnding)) return std::nullopt;
    pid_t id = 0;
    const char *from = name.data() + kName.size(), *to = name.data() + name.size() - kEnding.size();
    const auto [end, error] = std::from_chars(from, to, id);
    return error == std::errc{} && end == to && id > 0 ? std::optional(id) : std::nullopt;
}

bool runs(pid_t process) { return ::kill(process, 0) == 0 || errno == EPERM; }

}  // namespace

Recovery::Recovery(std::optional<fs::path> folder) : folder_(std::move(folder)) {}

std::optional<Scene> Recovery::left_behind() const {
    std::optional<Scene> found;
    std::error_code error;
    if (!folder_) return found;
    for (const fs::directory_entry& entry : fs::directory_iterator(*folder_, error)) {
        const auto process = owner(entry.path());
        if (!process || runs(*process)) continue;
        try {
            if (!found) found = parse_scene(read_file(entry.path(), kMostBytes), entry.path().string());
        } catch (const Error&) {  // a damaged one is of no use to anyone
        }
        fs::remove(entry.path(), error);
    }
    return found;
}

void Recovery::keep(const std::string& scene) const {
    if (!folder_) return;
    const fs::path file = *folder_ / (std::string(kName) + std::to_string(::getpid()) + std::string(kEnding));
    std::error_code error;
    if (scene.empty()) {
        fs::remove(file, error);
        return;
    }
    fs::create_directories(*folder_, error);
    try {
        write_file(file, scene);
    } catch (const Error&) {
        return;
    }
}

}  // namespace normalscope

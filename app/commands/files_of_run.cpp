#include "commands/files_of_run.h"

#include "core/base/error.h"
#include "core/base/links.h"
#include "core/lessons/lesson.h"

#include <sys/stat.h>
#include <unistd.h>

#include <locale.h>  // newlocale
#include <algorithm>
#include <array>
#include <cctype>
#include <climits>
#include <clocale>
#include <cwchar>
#include <cwctype>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

std::string with_other_case(std::string text) {
    for (char& c : text) {
        const auto u = static_cast<unsigned char>(c);
        c = static_cast<char>(std::islower(u) ? std::toupper(u) : std::tolower(u));
    }
    return text;
}

// Of any alphabet, as a folder that takes any case does; without the C library's UTF-8 of a to z only.
std::string in_small_letters(const std::string& text) {
    static const locale_t utf8 = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
    const locale_t before = utf8 ? ::uselocale(utf8) : nullptr;
    std::string small;
    for (std::size_t at = 0; at < text.size();) {
        wchar_t letter = 0;
        std::array<char, MB_LEN_MAX> bytes{};
        std::mbstate_t in{}, out{};
        const std::size_t length = std::mbrtowc(&letter, text.data() + at, text.size() - at, &in);
        const bool valid = length > 0 && length <= text.size() - at;
        const auto lower = static_cast<wchar_t>(std::towlower(static_cast<wint_t>(letter)));
        const std::size_t written = valid ? std::wcrtomb(bytes.data(), lower, &out) : bytes.size() + 1;
        if (written <= bytes.size())
            small.append(bytes.data(), written);
        else
            small += text[at];
        at += valid ? length : 1;
    }
    if (utf8) ::uselocale(before);
    return small;
}

bool is_found_by_other_case(const fs::path& file) {
    std::error_code ignored;
    return fs::equivalent(file, file.parent_path() / with_other_case(file.filename().string()), ignored);
}

// Whether a folder takes "A" and "a" for one name, judged by what is in it; where it is empty or not there yet, by its own
// name, which is found as the folder around it finds names.
bool takes_any_case(const fs::path& folder) {
    const auto has_letters = [](const fs::path& file) {
        const std::string name = file.filename().string();
        return with_other_case(name) != name;
    };
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
        if (has_letters(entry.path())) return is_found_by_other_case(entry.path());
    if (!folder.has_relative_path()) return false;
    return has_letters(folder) && fs::exists(folder, none) ? is_found_by_other_case(folder)
                                                           : takes_any_case(folder.parent_path());
}

std::string identity(const struct stat& status) {
    return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
}

// Empty for what is no plain file, and may well be written twice: /dev/null.
std::string identity(const fs::path& file) {
    struct stat status{};
    if (::stat(file.c_str(), &status) == 0) return S_ISREG(status.st_mode) ? identity(status) : "";
    std::error_code error;
    const fs::path end = fs::absolute(without_links(file), error);
    const fs::path parent = fs::weakly_canonical(end.parent_path(), error);
    // The folders that are there are known by what they are, the others by their names.
    fs::path folder = error ? end.parent_path() : parent;
    std::string name = end.filename().string();
    while (::stat(folder.c_str(), &status) != 0 && folder.has_relative_path()) {
        if (folder.has_filename()) name = folder.filename().string() + "/" + name;  // else it ends in a slash
        folder = folder.parent_path();
    }
    return identity(status) + "/" + (takes_any_case(folder) ? in_small_letters(name) : name);
}

}  // namespace

FilesOfRun::FilesOfRun(std::string manifest) : manifest_(std::move(manifest)) {
    if (!manifest_.empty()) reads(manifest_, "the manifest " + manifest_);
    struct stat status{};
    if (::fstat(STDOUT_FILENO, &status) == 0 && S_ISREG(status.st_mode))
        add(identity(status), {"standard output", true, false});
}

void FilesOfRun::add(const std::string& identity, const Entry& entry) {
    if (identity.empty()) return;
    const auto [place, is_new] = entries_.try_emplace(identity, entry);
    if (is_new) return;
    const Entry& other = place->second;
    if (!entry.written && !other.written) return;
    const std::string line = entry.name + " is the same file as " + other.name +
                             "; give each a file of its own, or one would be written over the other";
    if (entry.of_manifest || other.of_manifest) throw InputError(manifest_ + ": " + line);
    throw UsageError(line);
}

void FilesOfRun::reads(const fs::path& file, const std::string& name) { add(identity(file), {name, false, false}); }
void FilesOfRun::writes(const fs::path& file, const std::string& name) { add(identity(file), {name, true, false}); }
void FilesOfRun::writes(const Output& to, const std::string& option) {
    if (!to.is_standard()) writes(to.file, option + " " + to.file.string());
}
void FilesOfRun::manifest_writes(const fs::path& file, const std::string& name) {
    add(identity(file), {name, true, true});
}

void FilesOfRun::reads_scene(const std::string& file, const Scene& scene) {
    std::error_code ignored;
    const std::string name = fs::exists(file, ignored) ? file : file.substr(0, file.rfind('#'));  // a lesson's step
    if (fs::exists(name, ignored)) reads(name, "the scene " + name);
    if (const auto* mesh = std::get_if<MeshSurface>(&scene.surface)) reads(mesh->mesh, "the mesh " + mesh->mesh);
}

bool FilesOfRun::same(const fs::path& a, const fs::path& b) {
    const std::string identity_of_a = identity(a);
    return !identity_of_a.empty() && identity_of_a == identity(b);
}

}  // namespace normalscope

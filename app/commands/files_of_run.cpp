#include "commands/files_of_run.h"

#include "core/base/error.h"
#include "core/base/links.h"
#include "core/base/system.h"
#include "core/lessons/lesson.h"

#include <cctype>

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

// Empty for what is no plain file, and may well be written twice: /dev/null.
std::string identity(const fs::path& file) {
    std::error_code error;
    if (auto found = file_identity(file)) return fs::is_regular_file(file, error) ? *found : "";
    const fs::path end = fs::absolute(without_links(file), error);
    const fs::path parent = fs::weakly_canonical(end.parent_path(), error);
    // The folders that are there are known by what they are, the others by their names.
    fs::path folder = error ? end.parent_path() : parent;
    std::string name = end.filename().string();
    std::optional<std::string> there;
    while (!(there = file_identity(folder)) && folder.has_relative_path()) {
        if (folder.has_filename()) name = folder.filename().string() + "/" + name;  // else it ends in a slash
        folder = folder.parent_path();
    }
    return there.value_or("") + "/" + (takes_any_case(folder) ? in_lower_case(name) : name);
}

}  // namespace

FilesOfRun::FilesOfRun(std::string manifest) : manifest_(std::move(manifest)) {
    if (!manifest_.empty()) reads(manifest_, "the manifest " + manifest_);
    add(standard_output_identity(), {"standard output", true, false});
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

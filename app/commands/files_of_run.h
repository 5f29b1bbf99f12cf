#pragma once

#include "core/base/output.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <map>
#include <string>

namespace normalscope {

/// The files that one run reads and writes, known by what they are and not by what they are called: a link, a hard link,
/// `..`, and capitals where a disk does not tell them apart lead to the same one. A run that would write over what it
/// reads, or over what it writes itself, would judge its result by that result; it is refused before anything is written.
class FilesOfRun {
public:
    /// `manifest` names it in errors; empty for the commands that have none.
    explicit FilesOfRun(std::string manifest = {});

    /// `name` is what the user knows the file by: "--expect wing.png". A file that is not there yet counts as well, but
    /// devices, pipes and folders do not. Each throws where the file is taken already: UsageError where the command line
    /// contradicts itself, InputError where the manifest has a part in it.
    void reads(const std::filesystem::path& file, const std::string& name);
    void writes(const std::filesystem::path& file, const std::string& name);
    void writes(const Output& to, const std::string& option);
    /// The same for a file that the manifest names.
    void manifest_writes(const std::filesystem::path& file, const std::string& name);

    /// What FILE names, where that is a file, and the mesh that its scene has.
    void reads_scene(const std::string& file, const Scene& scene);

    /// Whether both names lead to one file, there or not.
    static bool same(const std::filesystem::path& a, const std::filesystem::path& b);

private:
    struct Entry {
        std::string name;
        bool written = false, of_manifest = false;
    };
    void add(const std::string& identity, const Entry& entry);

    std::string manifest_;
    std::map<std::string, Entry> entries_;  ///< by what the file is
};

}  // namespace normalscope

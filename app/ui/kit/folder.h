#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

struct FolderEntry {
    std::string name;  ///< in its folder, or a whole path
    bool folder = false;
};

/// A folder's listing, read once. Reading never throws: what cannot be read is said in `error`.
struct Folder {
    std::filesystem::path path;
    std::vector<FolderEntry> entries;  ///< folders first, each in alphabetical order; nothing hidden
    std::string error;
    bool cut = false;  ///< there were more than are listed
};

/// Lists a folder's folders and those of its files that end in one of `endings` (lower case, with the dot); all files if
/// there are none. Of no path at all: the drives, where there are any.
Folder read_folder(const std::filesystem::path& path, std::span<const std::string_view> endings);

/// Those of the files that are there and end in one of `endings`, each by its whole path, in the same order.
Folder listed(std::span<const std::string> files, std::span<const std::string_view> endings);

/// The path as UTF-8, for the screen.
std::string shown(const std::filesystem::path& path);

/// "~/x" and relative paths become absolute, starting from `folder`.
std::filesystem::path resolved(const std::string& typed, const std::filesystem::path& folder);

}  // namespace normalscope

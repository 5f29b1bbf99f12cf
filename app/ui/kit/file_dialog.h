#pragma once

#include "ui/kit/folder.h"
#include "ui/kit/requests.h"
#include "ui/kit/style.h"

#include <filesystem>
#include <string>
#include <vector>

namespace normalscope {

/// A dialog for one file at a time, in the window itself: it looks the same everywhere, and needs no toolkit.
class FileDialog {
public:
    enum class For { OpenAny, OpenMesh, SaveScene, SaveLesson, SavePicture };

    /// Shows it from the next frame on. What was typed is kept from the last time, and so is the folder.
    /// `proposed`: another folder for this time, which may not be there yet; empty: none.
    void open(For purpose, const std::filesystem::path& proposed = {});
    /// The open scene's file, which saving the scene proposes; empty where it has none.
    void set_scene_file(const std::string& file) { scene_file_ = file; }
    /// The files that were opened or saved, the newest first.
    std::vector<std::string>& recent_files() { return recent_files_; }
    const std::vector<std::string>& recent_files() const { return recent_files_; }
    bool is_open() const { return open_; }
    bool opens() const { return !saves(); }
    /// It does not come after all.
    void withdraw() { open_ = false; }

    void draw(const Look& look, ExtraLetters& letters, Requests& requests);

private:
    const Folder& listing() const { return recent_shown_ ? recent_ : folder_; }
    bool saves() const { return purpose_ >= For::SaveScene; }
    // Its parts, from top to bottom.
    void title(const Look& look);
    void list(const Look& look, Requests& requests);
    void name_field(Requests& requests);
    void complaint(const Look& look) const;
    void buttons(const Look& look, Requests& requests);

    void close();
    void choose(Requests& requests);
    void finish(const std::filesystem::path& file, Requests& requests);
    void enter(const std::filesystem::path& folder);

    For purpose_ = For::OpenAny;
    bool open_ = false, appearing_ = false;
    bool all_files_ = false;
    bool focus_name_ = false;
    bool listed_anew_ = false;   ///< some letters of its names may be missing
    bool recent_shown_ = false;  ///< in the folder's place
    Folder folder_, recent_;
    std::filesystem::path usual_, proposed_;  ///< the folder where none is proposed, and the one that is
    std::vector<std::string> recent_files_;
    std::string scene_file_;
    std::string name_;  ///< typed: a name in the folder, or a path
    std::string complaint_;
    std::filesystem::path to_overwrite_;  ///< asked about; empty if not
};

}  // namespace normalscope

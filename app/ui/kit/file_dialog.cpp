#include "ui/kit/file_dialog.h"

#include "core/base/error.h"
#include "core/base/system.h"
#include "core/lessons/open.h"
#include "core/mesh/mesh_file.h"
#include "ui/kit/dialog.h"
#include "ui/kit/widgets.h"

#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace normalscope {

namespace fs = std::filesystem;

namespace {

using For = FileDialog::For;
constexpr const char* kId = "##files";
constexpr float kRecentWidth = 84.0f;

struct Purpose {
    const char *title, *action;
    std::string_view ending;  ///< added to a name that has none; empty: never
    std::string_view name;    ///< to begin with
};
constexpr std::array<Purpose, 5> kPurposes{{
    {"Open a scene, a lesson or a mesh", "Open", "", ""},
    {"Open a mesh", "Open", "", ""},
    {"Save the scene", "Save", ".json", "scene.json"},
    {"Save the lesson", "Save", ".json", "lesson.json"},
    {"Save the picture", "Save", ".png", "normalscope.png"},
}};
const Purpose& about(For purpose) { return kPurposes[static_cast<std::size_t>(purpose)]; }

std::vector<std::string_view> endings(For purpose) {
    std::vector<std::string_view> meshes = mesh_endings();
    switch (purpose) {
        case For::OpenAny: meshes.insert(meshes.begin(), ".json"); return meshes;
        case For::OpenMesh: return meshes;
        case For::SaveScene:
        case For::SaveLesson: return {".json"};
        case For::SavePicture: return {".png", ".svg"};
    }
    return {};
}

std::string filter(For purpose) {
    switch (purpose) {
        case For::OpenAny: return "scenes, lessons and meshes (.json " + mesh_endings_in_words(" ", " ") + ")";
        case For::OpenMesh: return "meshes (" + mesh_endings_in_words(" ", " ") + ")";
        case For::SaveScene: return "scenes (.json)";
        case For::SaveLesson: return "lessons (.json)";
        case For::SavePicture: return "pictures (.png, or .svg: its vector parts)";
    }
    return {};
}

// A name; of a whole path the name first, and dim where it is.
void draw_name(const Look& look, ImVec2 at, const std::string& entry) {
    const fs::path path = entry;
    const std::string name = shown(path.filename());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(at, packed(look.text), name.c_str());
    if (!path.has_parent_path()) return;
    at.x += ImGui::CalcTextSize(name.c_str()).x + look.px(12);
    const float room = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x - at.x;
    list.AddText(at, packed(look.dim), shortened(shown(path.parent_path()), room).c_str());
}

}  // namespace

void FileDialog::open(For purpose, const fs::path& proposed) {
    if (purpose != purpose_ || name_.empty()) name_ = about(purpose).name;
    purpose_ = purpose;
    open_ = appearing_ = focus_name_ = true;
    complaint_.clear();
    to_overwrite_.clear();
    recent_ = listed(recent_files_, endings(purpose));
    std::error_code error;
    if (proposed_.empty()) usual_ = folder_.path;
    proposed_ = proposed;
    if (!proposed.empty() && !fs::is_directory(proposed, error))
        folder_ = {.path = proposed, .entries = {}, .error = {}};  // it comes with the file
    else
        enter(!proposed.empty() ? proposed : usual_.empty() ? fs::current_path(error) : usual_);
    if (purpose == For::SaveScene && !scene_file_.empty())
        name_ = shown(fs::proximate(scene_file_, folder_.path, error));
}

void FileDialog::enter(const fs::path& folder) {
    const std::vector<std::string_view> shown_endings =
        all_files_ ? std::vector<std::string_view>{} : endings(purpose_);
    listed_anew_ = true;
    recent_shown_ = false;
    Folder next = read_folder(folder.empty() && drives().empty() ? fs::path("/") : folder, shown_endings);
    complaint_ = next.error;
    // An unreadable folder is not entered, unless there is nothing else to show.
    if (next.error.empty() || folder_.path.empty()) folder_ = std::move(next);
}

void FileDialog::finish(const fs::path& file, Requests& requests) {
    switch (purpose_) {
        case For::OpenAny: requests.open = file.string(); break;
        case For::OpenMesh: requests.open_mesh = file.string(); break;
        case For::SaveScene: requests.save_scene = file; break;
        case For::SaveLesson: requests.save_lesson = file; break;
        case For::SavePicture: requests.save_picture = file; break;
    }
    name_ = saves() ? shown(file.filename()) : "";
    open_ = false;
    ImGui::CloseCurrentPopup();
}

// What Enter and the button do with what was typed.
void FileDialog::choose(Requests& requests) {
    if (name_.empty()) return;
    fs::path file = resolved(name_, folder_.path);
    std::error_code error;
    if (fs::is_directory(file, error)) {
        name_.clear();
        focus_name_ = true;
        return enter(file.has_filename() ? file : file.parent_path());
    }
    if (!saves()) {
        if (fs::exists(file, error))
            finish(file, requests);
        else
            complaint_ = shown(file) + ": no such file";
        return;
    }
    if (!file.has_extension()) file += about(purpose_).ending;
    if (!fs::is_directory(file.parent_path(), error) && file.parent_path() != proposed_)
        complaint_ = shown(file.parent_path()) + ": no such folder";
    else if (fs::exists(file, error) && to_overwrite_ != file)
        to_overwrite_ = file;
    else
        finish(file, requests);
}

void FileDialog::list(const Look& look, Requests& requests) {
    fs::path to_enter;
    bool chosen = false;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, look.card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px(8), look.px(8)));
    // As long as a screen allows that shows all else, too.
    const float height = std::clamp(ImGui::GetIO().DisplaySize.y - look.px(220), look.px(60), look.px(270));
    const bool listed = ImGui::BeginChild("##list", {0, height}, ImGuiChildFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleVar();
    if (listed) {
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(listing().entries.size()));
        while (clipper.Step())
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                const FolderEntry& entry = listing().entries[static_cast<std::size_t>(i)];
                ImGui::PushID(i);
                const ImVec2 at = ImGui::GetCursorScreenPos();
                const bool pressed = ImGui::Selectable("##entry", !entry.folder && entry.name == name_,
                                                       ImGuiSelectableFlags_AllowDoubleClick);
                if (pressed) focus_name_ = true;  // whoever goes on typing, types there
                // A folder opens by one click: there is nothing else to do with it.
                if (pressed && entry.folder) to_enter = resolved(entry.name, folder_.path);
                if (pressed && !entry.folder) {
                    name_ = entry.name;
                    to_overwrite_.clear();
                    chosen = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
                }
                ImDrawList& list = *ImGui::GetWindowDrawList();
                const float side = ImGui::GetFontSize();
                draw_icon(list, entry.folder ? Icon::Folder : Icon::File, {at.x + look.px(10), at.y + side / 2},
                          look.px(15), packed(look.dim));
                draw_name(look, {at.x + look.px(26), at.y}, entry.name);
                ImGui::PopID();
            }
        if (listing().entries.empty()) dim_text(look, "Nothing here of this kind.");
        if (listing().cut) dim_text(look, "… and more: type the name.");
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    if (!to_enter.empty()) enter(to_enter);
    if (chosen) choose(requests);
}

void FileDialog::close() {
    open_ = false;
    ImGui::CloseCurrentPopup();
}

void FileDialog::title(const Look& look) {
    ImGui::PushFont(look.fonts.strong);
    ImGui::TextUnformatted(about(purpose_).title);
    ImGui::PopFont();

    if (icon_button(look, "##parent",
                    {.icon = Icon::Up,
                     .about = "To the folder above",
                     .enabled = !recent_shown_ &&
                                (folder_.path.has_relative_path() || (!folder_.path.empty() && !drives().empty())),
                     .side = 30}))
        enter(folder_.path.has_relative_path() ? folder_.path.parent_path() : fs::path());
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const bool recent = opens() && !recent_.entries.empty();
    const float right = recent ? look.px(kRecentWidth) : 0.0f;
    const std::string place = recent_shown_          ? "Recent files"
                              : folder_.path.empty() ? "All drives"
                                                     : shown(folder_.path);
    dim_text(look, shortened(place, ImGui::GetContentRegionAvail().x - right));
    tip(look, place.c_str());
    if (!recent) return;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - right);
    if (accented_button(look, "Recent", recent_shown_, {right, 0})) {
        recent_shown_ = !recent_shown_;
        listed_anew_ = focus_name_ = true;
    }
    tip(look, recent_shown_ ? "Back to the folder" : "Files that were opened or saved recently");
}

void FileDialog::name_field(Requests& requests) {
    if (std::exchange(focus_name_, false)) {
        ImGui::SetWindowFocus();  // as long as the list has it, no field of the dialog is found
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##name", saves() ? "name, or a path" : "type a name or a path", &name_,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll)) {
        focus_name_ = true;
        choose(requests);
    }
    if (ImGui::IsItemEdited()) {
        to_overwrite_.clear();
        complaint_.clear();
    }
}

void FileDialog::complaint(const Look& look) const {
    if (complaint_.empty() && to_overwrite_.empty()) return;
    const std::string text =
        to_overwrite_.empty() ? complaint_ : shown(to_overwrite_.filename()) + " is there already. Overwrite it?";
    ImGui::PushStyleColor(ImGuiCol_Text, look.bad);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void FileDialog::buttons(const Look& look, Requests& requests) {
    const Purpose& purpose = about(purpose_);
    const float button = look.px(108), gap = look.px(8);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + look.px(4));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px(4), look.px(1)));
    if (ImGui::Checkbox("all files", &all_files_)) {
        enter(folder_.path);
        focus_name_ = true;
    }
    ImGui::PopStyleVar();
    tip(look, ("Otherwise only " + filter(purpose_)).c_str());
    if (purpose_ == For::SavePicture) {
        ImGui::SameLine(0, look.px(16));
        if (ImGui::Button("Copy as command")) {
            requests.copy_command = true;
            close();
        }
        tip(look, "Copies the command line that draws this picture, for scripts and tests (Ctrl+C)");
    }
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 2 * button - gap);
    const bool cancel = ImGui::Button("Cancel", {button, 0});
    ImGui::SameLine(0, gap);
    ImGui::BeginDisabled(name_.empty());
    const bool accepted =
        accented_button(look, to_overwrite_.empty() ? purpose.action : "Overwrite", true, {button, 0});
    ImGui::EndDisabled();
    if (accepted) choose(requests);
    if (open_ && (cancel || ImGui::IsKeyPressed(ImGuiKey_Escape, false))) close();
}

void FileDialog::draw(const Look& look, ExtraLetters& letters, Requests& requests) {
    if (appearing_) ImGui::OpenPopup(kId);
    appearing_ = false;
    if (!open_) return;
    if (std::exchange(listed_anew_, false))
        for (const FolderEntry& entry : listing().entries) letters.want(entry.name, look.fonts.body);
    letters.want(name_, look.fonts.body);

    const bool visible = begin_dialog(look, kId, 620);
    if (!visible) {
        open_ = false;  // Escape closes modals that have the keyboard
        return;
    }
    title(look);
    list(look, requests);  // which may close it, as the name's field may
    if (open_) name_field(requests);
    if (open_) {
        complaint(look);
        buttons(look, requests);
    }
    ImGui::EndPopup();
}

}  // namespace normalscope

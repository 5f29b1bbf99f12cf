#pragma once

#include "core/lessons/writing.h"
#include "core/surface/surface.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace normalscope {

/// What people have been asked, and the number of the choice that they made.
enum class Asked { Closing, Recovering, LeavingLesson };
struct Reply {
    Asked asked;
    std::size_t choice;
};

/// A lesson is to be written: a new one, or the one that is gone through; or that is done for now.
enum class Writing { New, ThisLesson, Done };

/// What the interface asks of the program, beyond edits of the scene.
struct Requests {
    bool undo = false, redo = false;
    bool step = false;         ///< what the scene is now is one step to undo, though the editing goes on
    std::optional<Rule> rule;  ///< was chosen
    bool make_room = false;    ///< the surface is another, or as large as it was not: it should be in the picture
    bool full_screen = false, quit = false;
    bool copy_command = false;  ///< the command line that captures what is shown
    bool end_presenting = false;
    bool copy_link = false, copy_equations = false;
    bool copy_frame = false;               ///< HTML that shows it in another page
    std::optional<std::string> open;       ///< a scene, a mesh, a lesson, or the name of a built-in one
    std::optional<std::string> open_mesh;  ///< a mesh as the scene's surface, all else kept
    bool list_lessons = false;             ///< there may be others by now
    bool save = false;                     ///< to the open file, or to one that is asked for
    std::optional<std::filesystem::path> save_scene;
    std::optional<std::filesystem::path> save_picture;
    std::optional<Writing> writing;
    std::optional<Draft> edit;  ///< what is written is this from now on
    bool save_lesson_as = false;
    std::optional<std::filesystem::path> save_lesson;
    std::optional<Reply> reply;
};

/// What the interface shows and cannot work out from the scene.
struct Status {
    bool can_undo = false, can_redo = false;
    std::optional<ErrorStatistics> errors;
    std::string file;       ///< the open scene's file or name; empty if none
    bool has_file = false;  ///< which is the user's, and can be saved to
    bool by_hand = false;   ///< a user's hand changes the scene, and no command does
    bool in_lesson = false;
    Draft draft{};                ///< the lesson that is being written
    bool unsaved_lesson = false;  ///< which no file holds as it is
    bool as_named = true;         ///< surface and map are still those of which the scene's `about` speaks
};

}  // namespace normalscope

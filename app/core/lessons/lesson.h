#pragma once

#include "core/lessons/scene_path.h"
#include "core/math/highlight.h"
#include "core/math/point_label.h"
#include "core/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

struct Choice {
    std::string text;
    bool right = false;
    std::string because;  ///< what is said when it is chosen; may be empty
    friend bool operator==(const Choice&, const Choice&) = default;
};
/// A short question, of whose choices exactly one is right.
struct Question {
    std::string text;
    std::vector<Choice> choices;
    friend bool operator==(const Question&, const Question&) = default;
};

struct LessonStep {
    Scene scene;                                               ///< the whole scene, not only what changed
    std::string caption;                                       ///< what is said
    std::string look_at;                                       ///< where to look; may be empty
    std::vector<std::string> equations;                        ///< in a line each, as core/base/math_text.h reads them
    enum class BoardIs { Kept, Wiped } board = BoardIs::Kept;  ///< before these are written on it
    std::string tab;                                           ///< what is opened beside the picture; may be empty
    std::optional<std::size_t> line;     ///< of the derivation, from 0, whose arrows stand in the picture
    std::string to_try;                  ///< what asks for a hand on the mouse: said in the window alone
    std::optional<double> seconds;       ///< that it stands in a video; empty: as long as its words take to read
    std::optional<Highlight> highlight;  ///< the symbol and its arrow that stand out
    std::vector<PointLabel> labels;
    std::vector<ScenePath> paths;  ///< that lead to the scene, when the step is reached
    std::string notes;             ///< for whoever teaches, never for a room
    std::optional<Question> question;
    std::string source;  ///< its JSON, of which save_lesson keeps what is not edited; empty: it is new
    /// What the caption claims: a dotted path in `--numbers` and its value. The tests hold it against the scene.
    std::map<std::string, double> numbers;
};

/// A row of scenes with what is to be said of each. A file of its own, so that a lecturer writes one without compiling.
struct Lesson {
    std::string name;  ///< a built-in one's, or the file's path
    std::string title, about;
    std::vector<LessonStep> steps;
};

inline constexpr std::size_t kMostLessonSteps = 200;
/// What the first step changes.
Scene scene_before_steps();

/// A lesson's text and where it is from, for errors, which tell line and step.
struct LessonSource {
    std::string_view text;
    std::string name;
    std::filesystem::path folder;  ///< from which mesh files are found
};
/// Throws InputError.
Lesson parse_lesson(const LessonSource& source);
/// The same of the text's JSON, where somebody has that already.
Lesson lesson_of_json(const nlohmann::ordered_json& json, const LessonSource& source);

struct ListedLesson {
    std::string name, title, about;
    std::size_t steps = 0;
};
/// Those in assets/lessons, in their order.
const std::vector<ListedLesson>& built_in_lessons();

bool is_built_in_lesson(const std::string& name);
/// Of the name of one.
Lesson built_in_lesson(const std::string& name);

}  // namespace normalscope

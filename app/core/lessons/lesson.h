#pragma once

#include "core/scene/scene.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

struct Answer {
    std::string text;
    bool right = false;
    std::string because;  ///< what is said when it is chosen
    friend bool operator==(const Answer&, const Answer&) = default;
};
/// A short question, of whose choices exactly one is right.
struct Question {
    std::string text;
    std::vector<Answer> choices;
    friend bool operator==(const Question&, const Question&) = default;
};

struct LessonStep {
    Scene scene;                         ///< the whole scene, not only what changed
    std::string caption;                 ///< what is said
    std::string look_at;                 ///< where to look; may be empty
    std::vector<std::string> equations;  ///< in a line each; "n_obj", "n_world" and the like are set as symbols
    std::string tab;                     ///< what is opened beside the picture; may be empty
    std::optional<Question> question;
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

/// A lesson from JSON text; `source` names the text in errors, which tell line and step. Mesh files are found from
/// `folder`. Throws InputError.
Lesson parse_lesson(std::string_view text, std::string_view source, const std::string& folder = {});

struct BuiltInLesson {
    std::string name, title, about;
};
/// Those in assets/lessons, in their order.
const std::vector<BuiltInLesson>& built_in_lessons();

/// A built-in lesson's name, or a JSON file that holds a lesson. Throws InputError where a file cannot be read.
bool is_lesson(const std::string& file_or_name);
/// Throws InputError.
Lesson load_lesson(const std::string& file_or_name);

/// "NAME#3": the third step of a lesson, for whoever wants a scene. Empty for whatever is not of that form.
struct LessonPlace {
    std::string lesson;
    std::size_t step = 0;  ///< counted from 0
};
std::optional<LessonPlace> lesson_place(const std::string& file_or_name);

}  // namespace normalscope

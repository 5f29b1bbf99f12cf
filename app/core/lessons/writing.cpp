#include "core/lessons/writing.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/system.h"
#include "core/lessons/open.h"
#include "core/scene/scene_patch.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

// What stands in a file for what nobody has written yet.
constexpr const char *kAnyQuestion = "?", *kAnyAnswer = "…";

LessonStep new_step(const Scene& scene) {
    LessonStep step;
    step.scene = scene;
    return step;
}

void put(Json& step, const char* key, const std::string& words) {
    if (words.empty())
        step.erase(key);
    else
        step[key] = words;
}

// Every question can be asked, in a file.
Question whole(Question question) {
    const auto say = [](std::string& words, const char* at_least) {
        if (words.empty()) words = at_least;
    };
    say(question.text, kAnyQuestion);
    question.choices.resize(std::max<std::size_t>(question.choices.size(), 2));
    for (Choice& choice : question.choices) say(choice.text, kAnyAnswer);
    if (std::ranges::none_of(question.choices, &Choice::right)) question.choices.front().right = true;
    return question;
}

void put(Json& step, const std::optional<Question>& question) {
    if (!question) {
        step.erase("question");
        return;
    }
    const Question asked = whole(*question);
    Json choices = Json::array();
    for (const Choice& choice : asked.choices) {
        Json& json = choices.emplace_back(Json{{"text", choice.text}});
        if (choice.right) json["right"] = true;
        put(json, "because", choice.because);
    }
    step["question"] = Json{{"ask", asked.text}, {"choices", std::move(choices)}};
}

Json step_json(const LessonStep& step, const Scene& before, const Scene& here) {
    Json json = step.source.empty() ? Json::object() : Json::parse(step.source);
    put(json, "caption", step.caption);
    const Json patch = patch_between(before, here);
    if (patch.empty())
        json.erase("scene");
    else
        json["scene"] = patch;
    put(json, "look_at", step.look_at);
    json["equations"] = step.equations;
    if (step.equations.empty()) json.erase("equations");
    put(json, "notes", step.notes);
    put(json, step.question);
    return json;
}

std::string gap_of(const Question& question) {
    const auto open = [](const Choice& choice) { return choice.text.empty() || choice.text == kAnyAnswer; };
    if (question.text.empty() || question.text == kAnyQuestion) return "asks a question that has no words yet";
    if (question.choices.size() < 2) return "asks a question that needs two answers at least";
    return std::ranges::any_of(question.choices, open) ? "has an answer without words" : "";
}

// A scene's work, or a mistyped name, is not lost to a lesson.
void refuse_other_files(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return;
    if (!std::holds_alternative<OpenedLesson>(open_name(text_of(file))))
        throw InputError(text_of(file), "holds a scene; give the lesson a name of its own");
}

}  // namespace

Lesson new_lesson(const Scene& scene) {
    return {.name = "new lesson", .title = "My lesson", .about = "", .steps = {new_step(scene)}};
}

Lesson with_step_after(Lesson lesson, std::size_t step, const Scene& scene) {
    LessonStep added = new_step(scene);
    added.scene.theme = lesson.steps.at(step).scene.theme;  // the room's light is no part of it
    lesson.steps.insert(lesson.steps.begin() + static_cast<std::ptrdiff_t>(step) + 1, std::move(added));
    return lesson;
}

Lesson with_swapped(Lesson lesson, std::size_t one, std::size_t other) {
    std::swap(lesson.steps.at(one), lesson.steps.at(other));
    return lesson;
}

Lesson without_step(Lesson lesson, std::size_t step) {
    const auto at = &lesson.steps.at(step) - lesson.steps.data();
    if (lesson.steps.size() > 1) lesson.steps.erase(lesson.steps.begin() + at);
    return lesson;
}

std::vector<std::string> gaps(const Lesson& lesson) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const LessonStep& step = lesson.steps[i];
        const auto say = [&](const std::string& what) {
            if (!what.empty()) all.push_back("step " + std::to_string(i + 1) + " " + what);
        };
        say(step.caption.empty() ? "has no words yet" : "");
        if (step.question) say(gap_of(*step.question));
    }
    return all;
}

std::string lesson_text(const Lesson& lesson, const std::filesystem::path& file) {
    Json json{{"normalscope", 1}, {"lesson", lesson.title}};
    if (!lesson.about.empty()) json["about"] = lesson.about;
    json["steps"] = Json::array();
    Scene before = scene_before_steps();
    for (const LessonStep& step : lesson.steps) {
        const Scene here = as_saved_in(step.scene, file);
        json["steps"].push_back(step_json(step, before, here));
        // Every step says something, in a file.
        if (step.caption.empty()) json["steps"].back()["caption"] = "Step " + std::to_string(json["steps"].size());
        before = here;
    }
    return json_text(json) + "\n";
}

void save_lesson(const Lesson& lesson, const std::filesystem::path& file) {
    refuse_other_files(file);
    const std::string text = lesson_text(lesson, file);
    (void)parse_lesson({text, text_of(file), file.parent_path()});
    write_file(file, text);
}

}  // namespace normalscope

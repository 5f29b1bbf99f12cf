#include "core/lessons/lesson.h"

#include "core/base/json_object.h"
#include "core/base/json_position.h"
#include "core/base/json_reading.h"
#include "core/base/text.h"
#include "core/base/utf8.h"
#include "core/lessons/lesson_limits.h"
#include "core/lessons/tabs.h"
#include "core/scene/scene_patch.h"

#include <embedded.h>

#include <algorithm>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kLessonFolder = "assets/lessons/";

std::string words(const Json& json, const JsonPath& path, std::size_t most) {
    if (!json.is_string() || json.get_ref<const std::string&>().empty())
        throw JsonError(path, "expected words, in quotes");
    auto text = json.get<std::string>();
    if (const std::size_t characters = columns(text); characters > most)
        throw JsonError(path, "is " + std::to_string(characters) + " characters long; at most " + std::to_string(most) +
                                  " leave room for the picture");
    std::ranges::replace_if(text, [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
    return text;
}

std::string needed_words(JsonObject& object, const char* key, std::size_t most) {
    const Json& json = object.need(key);
    return words(json, object.at(key), most);
}
std::string words_if_any(JsonObject& object, const char* key, std::size_t most) {
    const Json* json = object.find(key);
    return json ? words(*json, object.at(key), most) : std::string();
}

std::vector<std::string> read_equations(const Json& json, const JsonPath& path) {
    if (!json.is_array() || json.size() > kMostEquations)
        throw JsonError(path, "expected an array of at most " + std::to_string(kMostEquations) + " lines");
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < json.size(); ++i) lines.push_back(words(json[i], below(path, i), kLongestNote));
    return lines;
}

std::string read_tab(const Json& json, const JsonPath& path) {
    const std::vector<std::string> names = tab_names();
    const std::string name = words(json, path, kLongestNote);
    const std::string_view plain = without_numbers(name);
    if (std::ranges::find(names, plain) == names.end() && !line_of_tab(plain))
        fail_kind(path, "one of " + joined(names) + " (" + tabs_of_the_derivation() + ")", json);
    return name;
}

std::size_t read_line(const Json& json, const JsonPath& path) {
    int line = 0;
    read_value(json, path, line, Range{1, kLinesWithArrows});
    return static_cast<std::size_t>(line - 1);
}

LessonStep::BoardIs read_board(const Json& json, const JsonPath& path) {
    if (json == "keep") return LessonStep::BoardIs::Kept;
    if (json == "wipe") return LessonStep::BoardIs::Wiped;
    fail_kind(path, "keep or wipe", json);
}

Highlight read_highlight(const Json& json, const JsonPath& path) {
    static const std::map<std::string, Highlight> kNames{{"n_obj", {.symbol = Symbol::NObject}},
                                                         {"v_obj", {.symbol = Symbol::VObject}},
                                                         {"n_world", {.symbol = Symbol::NWorld}},
                                                         {"n_naive", {.symbol = Symbol::NWorld, .naive = true}},
                                                         {"v_world", {.symbol = Symbol::VWorld}}};
    if (json.is_string())
        if (const auto found = kNames.find(json.get<std::string>()); found != kNames.end()) return found->second;
    fail_kind(path, "one of n_obj v_obj n_world n_naive v_world", json);
}

PointLabel read_label(const Json& json, const JsonPath& path) {
    JsonObject object(json, path, "an object with the keys text, and at or on");
    PointLabel label{.text = needed_words(object, "text", kLongestLabel), .at = {}};
    const bool carried = object.find("on") != nullptr;
    const char* key = carried ? "on" : "at";
    const Json& place = object.need(key);
    if (!place.is_array() || place.size() != 3) fail_kind(object.at(key), "three numbers", place);
    glm::dvec3 xyz(0.0);
    for (glm::length_t i = 0; i < 3; ++i)
        read_value(place[static_cast<std::size_t>(i)], below(object.at(key), static_cast<std::size_t>(i)), xyz[i],
                   kAnyNumber);
    if (carried)
        label.at = Point<Object>{xyz};
    else
        label.at = Point<World>{xyz};
    object.no_other_keys();
    return label;
}

std::vector<PointLabel> read_labels(const Json& json, const JsonPath& path) {
    if (!json.is_array()) return {read_label(json, path)};
    if (json.size() > kMostLabels) throw JsonError(path, "expected at most " + std::to_string(kMostLabels) + " labels");
    std::vector<PointLabel> labels;
    for (std::size_t i = 0; i < json.size(); ++i) labels.push_back(read_label(json[i], below(path, i)));
    return labels;
}

Choice read_choice(const Json& json, const JsonPath& path) {
    JsonObject object(json, path, "an object with the keys text, right and because");
    Choice choice{.text = needed_words(object, "text", kLongestChoice), .because = {}};
    object.read("right", choice.right);
    choice.because = words_if_any(object, "because", kLongestNote);
    object.no_other_keys();
    return choice;
}

Question read_question(const Json& json, const JsonPath& path) {
    JsonObject object(json, path, "an object with the keys ask and choices");
    Question question;
    question.text = needed_words(object, "ask", kLongestNote);
    const Json& list = object.need("choices");
    const JsonPath choices = object.at("choices");
    if (!list.is_array() || list.size() < 2 || list.size() > kMostChoices)
        throw JsonError(choices, "expected an array of 2 to " + std::to_string(kMostChoices) + " choices");
    for (std::size_t i = 0; i < list.size(); ++i) question.choices.push_back(read_choice(list[i], below(choices, i)));
    object.no_other_keys();
    if (std::ranges::count(question.choices, true, &Choice::right) != 1)
        throw JsonError(choices, "exactly one of them must be right");
    return question;
}

std::map<std::string, double> read_numbers(const Json& json, const JsonPath& path) {
    if (!json.is_object()) fail_kind(path, "an object: paths in the numbers of capture, and their values", json);
    std::map<std::string, double> result;
    for (const auto& [key, value] : json.items()) read_value(value, below(path, key), result[key], kAnyNumber);
    return result;
}

LessonStep read_step(const Json& json, const JsonPath& path, const Scene& before) {
    JsonObject object(json, path);
    LessonStep step;
    step.scene = before;
    if (const Json* scene = object.find("scene")) step.scene = with_patch(before, *scene, object.at("scene"));
    step.caption = needed_words(object, "caption", kLongestCaption);
    step.look_at = words_if_any(object, "look_at", kLongestNote);
    if (const Json* equations = object.find("equations"))
        step.equations = read_equations(*equations, object.at("equations"));
    if (const Json* tab = object.find("tab")) step.tab = read_tab(*tab, object.at("tab"));
    if (const Json* line = object.find("derivation")) step.line = read_line(*line, object.at("derivation"));
    step.to_try = words_if_any(object, "try", kLongestNote);
    if (const Json* seconds = object.find("seconds"))
        read_value(*seconds, object.at("seconds"), step.seconds.emplace(), Range{1, 600});
    if (const Json* board = object.find("board")) step.board = read_board(*board, object.at("board"));
    if (const Json* what = object.find("highlight")) step.highlight = read_highlight(*what, object.at("highlight"));
    if (const Json* label = object.find("label")) step.labels = read_labels(*label, object.at("label"));
    if (const Json* paths = object.find("path")) {
        step.paths = read_paths(*paths, object.at("path"), step.scene);
        step.scene = on_path(step.scene, step.paths, 1.0);
    }
    step.notes = words_if_any(object, "notes", kLongestNotes);
    if (const Json* question = object.find("question")) step.question = read_question(*question, object.at("question"));
    if (const Json* numbers = object.find("numbers")) step.numbers = read_numbers(*numbers, object.at("numbers"));
    object.no_other_keys();
    step.source = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return step;
}

Lesson read_lesson(const Json& json) {
    JsonObject object(json, {}, "an object with the keys lesson and steps");
    object.read_format("normalscope");
    Lesson lesson;
    lesson.title = needed_words(object, "lesson", kLongestNote);
    lesson.about = words_if_any(object, "about", kLongestNote);
    const Json& steps = object.need("steps");
    const JsonPath path = object.at("steps");
    if (!steps.is_array() || steps.empty()) throw JsonError(path, "expected an array with at least one step");
    if (steps.size() > kMostLessonSteps)
        throw JsonError(path, "has " + std::to_string(steps.size()) + " steps; at most " +
                                  std::to_string(kMostLessonSteps) + " are allowed, so make several lessons of it");
    object.no_other_keys();
    Scene scene = scene_before_steps();
    for (std::size_t i = 0; i < steps.size(); ++i) {
        lesson.steps.push_back(read_step(steps[i], below(path, i), scene));
        scene = lesson.steps.back().scene;
    }
    return lesson;
}

// "my.json, line 8, step 2: scene.stack.0.scale.1: …"
InputError lesson_error(const JsonError& error, const LessonSource& source) {
    JsonPath path = error.path;
    std::string where = source.name;
    if (!path.empty()) where += ", line " + std::to_string(json_line(source.text, path));
    if (path.size() >= 2 && path[0] == "steps") {
        where += ", step " + std::to_string(std::stoul(path[1]) + 1);
        path.erase(path.begin(), path.begin() + 2);
    }
    return InputError(where, JsonError(path, error.reason).what());
}

std::optional<std::string_view> built_in_text(const std::string& name) {
    return embedded::file(std::string(kLessonFolder) + name + ".json");
}

}  // namespace

Scene scene_before_steps() {
    Scene scene;
    scene.camera.zoom = 1.0;  // so that nothing jumps from step to step
    return scene;
}

Lesson lesson_of_json(const Json& json, const LessonSource& source) {
    Lesson lesson;
    try {
        lesson = read_lesson(json);
    } catch (const JsonError& e) {
        throw lesson_error(e, source);
    }
    lesson.name = source.name;
    for (LessonStep& step : lesson.steps)
        if (MeshSurface* m = std::get_if<MeshSurface>(&step.scene.surface))
            m->mesh = (source.folder / m->mesh).lexically_normal().generic_string();
    return lesson;
}

Lesson parse_lesson(const LessonSource& source) {
    try {
        return lesson_of_json(read_json(source.text), source);
    } catch (const JsonError& e) {
        throw lesson_error(e, source);
    }
}

const std::vector<ListedLesson>& built_in_lessons() {
    static const std::vector<ListedLesson> lessons = [] {
        std::vector<ListedLesson> list;
        for (const std::string_view file : embedded::names()) {
            if (!file.starts_with(kLessonFolder) || !file.ends_with(".json")) continue;
            const std::string name(file.substr(kLessonFolder.size(), file.size() - kLessonFolder.size() - 5));
            // Only the head: checking every scene of every lesson is for whoever opens one.
            const Json head = Json::parse(*embedded::file(file), nullptr, false);
            list.push_back({name, head.value("lesson", name), head.value("about", ""), head["steps"].size()});
        }
        std::ranges::sort(list, {}, &ListedLesson::name);
        return list;
    }();
    return lessons;
}

bool is_built_in_lesson(const std::string& name) { return built_in_text(name).has_value(); }

Lesson built_in_lesson(const std::string& name) { return parse_lesson({built_in_text(name).value(), name, {}}); }

}  // namespace normalscope

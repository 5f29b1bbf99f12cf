#include "core/lessons/lesson.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_position.h"
#include "core/base/json_reading.h"
#include "core/scene/scene_patch.h"

#include <embedded.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestLessonFile = std::size_t{4} << 20;
constexpr std::string_view kLessonFolder = "assets/lessons/";
// Beyond these, words would leave no room for the picture.
constexpr std::size_t kLongestCaption = 400, kLongestNote = 240, kLongestChoice = 90, kMostEquations = 3,
                      kMostChoices = 5;
constexpr int kDeepest = 40;

/// Reads one lesson; knows where it is, for errors.
class LessonReader {
public:
    LessonReader(std::string_view text, std::string_view source) : text_(text), source_(source) {}

    Lesson read() {
        // The syntax's errors come with their line already, and as scenes' do.
        const Json root = read_json(text_, source_, kDeepest);
        if (!root.is_object()) fail({}, "expected an object with the keys lesson and steps");
        known(root, {}, {"normalscope", "lesson", "about", "steps"});
        if (const auto it = root.find("normalscope"); it != root.end() && *it != 1)
            fail({"normalscope"}, "this format is not known; this program reads format 1");
        Lesson lesson;
        lesson.name = source_;
        lesson.title = words(root, {}, "lesson", kLongestNote, true);
        lesson.about = words(root, {}, "about", kLongestNote, false);
        const auto steps = root.find("steps");
        if (steps == root.end() || !steps->is_array() || steps->empty())
            fail({"steps"}, "expected an array with at least one step");
        if (steps->size() > kMostLessonSteps)
            fail({"steps"}, "has " + std::to_string(steps->size()) + " steps; at most " +
                                std::to_string(kMostLessonSteps) + " are allowed, so make several lessons of it");
        Scene scene;
        for (std::size_t i = 0; i < steps->size(); ++i) {
            lesson.steps.push_back(step((*steps)[i], {"steps", std::to_string(i)}, scene));
            scene = lesson.steps.back().scene;
        }
        return lesson;
    }

private:
    using Path = std::vector<std::string>;

    [[noreturn]] void fail(const Path& path, const std::string& what) const {
        std::string where = source_ + ", line " + std::to_string(json_line(text_, path));
        std::size_t shown = 0;
        if (path.size() >= 2 && path[0] == "steps") {
            where += ", step " + std::to_string(std::stoul(path[1]) + 1);
            shown = 2;
        }
        std::string key;
        for (; shown < path.size(); ++shown) key += (key.empty() ? "" : ".") + path[shown];
        std::string line = where + ": " + key + (key.empty() ? "" : ": ") + what;
        std::ranges::replace_if(line, [](unsigned char c) { return c < ' ' || c == 127; }, '?');
        throw InputError(line);
    }

    static Path below(Path path, std::string key) {
        path.push_back(std::move(key));
        return path;
    }

    void known(const Json& object, const Path& path, std::initializer_list<std::string_view> keys) const {
        for (const auto& [key, ignored] : object.items()) {
            if (std::ranges::find(keys, key) != keys.end()) continue;
            std::string line = "unknown key; known here: ";
            for (const std::string_view k : keys) line += (k == *keys.begin() ? "" : ", ") + std::string(k);
            fail(below(path, key), line);
        }
    }

    std::string words(const Json& object, const Path& path, const char* key, std::size_t most, bool needed) const {
        const auto it = object.find(key);
        if (it == object.end()) {
            if (needed) fail(path, "lacks the key " + std::string(key));
            return {};
        }
        return sentence(*it, below(path, key), most);
    }
    std::string sentence(const Json& json, const Path& path, std::size_t most) const {
        if (!json.is_string() || json.get<std::string>().empty()) fail(path, "expected words, in quotes");
        auto text = json.get<std::string>();
        if (text.size() > most)
            fail(path, "is " + std::to_string(text.size()) + " bytes long; at most " + std::to_string(most) +
                           " leave room for the picture");
        std::ranges::replace_if(text, [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
        return text;
    }

    LessonStep step(const Json& json, const Path& path, const Scene& before) const {
        if (!json.is_object()) fail(path, "expected an object");
        known(json, path, {"scene", "caption", "look_at", "equations", "tab", "question", "numbers"});
        LessonStep step;
        step.caption = words(json, path, "caption", kLongestCaption, true);
        step.look_at = words(json, path, "look_at", kLongestNote, false);
        if (const auto it = json.find("equations"); it != json.end()) step.equations = equations(*it, path);
        if (const auto it = json.find("tab"); it != json.end()) step.tab = tab(*it, below(path, "tab"));
        if (const auto it = json.find("question"); it != json.end()) step.question = question(*it, path);
        if (const auto it = json.find("numbers"); it != json.end()) step.numbers = numbers(*it, path);
        step.scene = before;
        if (const auto it = json.find("scene"); it != json.end()) step.scene = patched(before, *it, path);
        return step;
    }

    // The patch's errors begin with the path below "scene".
    Scene patched(const Scene& before, const Json& patch, const Path& path) const {
        const Path here = below(path, "scene");
        if (!patch.is_object()) fail(here, "expected an object: the scene's keys that change");
        try {
            return with_patch(before, patch.dump(-1, ' ', false, Json::error_handler_t::replace), "");
        } catch (const InputError& e) {
            const std::string line = std::string_view(e.what()).starts_with(": ") ? e.what() + 2 : e.what();
            const auto colon = line.find(": ");
            Path there = here;
            for (std::size_t begin = 0; colon != std::string::npos && begin < colon;) {
                const std::size_t end = std::min(line.find('.', begin), colon);
                there.push_back(line.substr(begin, end - begin));
                begin = end + 1;
            }
            fail(there, colon == std::string::npos ? line : line.substr(colon + 2));
        }
    }

    std::vector<std::string> equations(const Json& json, const Path& path) const {
        const Path here = below(path, "equations");
        if (!json.is_array() || json.size() > kMostEquations)
            fail(here, "expected an array of at most " + std::to_string(kMostEquations) + " lines");
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < json.size(); ++i)
            lines.push_back(sentence(json[i], below(here, std::to_string(i)), kLongestNote));
        return lines;
    }

    std::string tab(const Json& json, const Path& path) const {
        constexpr std::array<std::string_view, 5> kTabs{"derivation", "stack", "maps", "error", "ray"};
        const std::string name = sentence(json, path, kLongestNote);
        if (std::ranges::find(kTabs, name) == kTabs.end())
            fail(path, "expected one of derivation, stack, maps, error, ray, found \"" + name + "\"");
        return name;
    }

    Question question(const Json& json, const Path& path) const {
        const Path here = below(path, "question");
        if (!json.is_object()) fail(here, "expected an object with the keys ask and choices");
        known(json, here, {"ask", "choices"});
        Question question;
        question.text = words(json, here, "ask", kLongestNote, true);
        const Path choices = below(here, "choices");
        const auto list = json.find("choices");
        if (list == json.end() || !list->is_array() || list->size() < 2 || list->size() > kMostChoices)
            fail(choices, "expected an array of 2 to " + std::to_string(kMostChoices) + " choices");
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Path at = below(choices, std::to_string(i));
            const Json& each = (*list)[i];
            if (!each.is_object()) fail(at, "expected an object with the keys text, right and because");
            known(each, at, {"text", "right", "because"});
            Answer choice{.text = words(each, at, "text", kLongestChoice, true),
                          .because = words(each, at, "because", kLongestNote, true)};
            if (const auto right = each.find("right"); right != each.end()) {
                if (!right->is_boolean()) fail(below(at, "right"), "expected true or false");
                choice.right = right->get<bool>();
            }
            question.choices.push_back(std::move(choice));
        }
        if (std::ranges::count(question.choices, true, &Answer::right) != 1)
            fail(choices, "exactly one of them must be right");
        return question;
    }

    std::map<std::string, double> numbers(const Json& json, const Path& path) const {
        const Path here = below(path, "numbers");
        if (!json.is_object()) fail(here, "expected an object: paths in the numbers of capture, and their values");
        std::map<std::string, double> result;
        for (const auto& [key, value] : json.items()) {
            if (!value.is_number()) fail(below(here, key), "expected a number");
            result[key] = value.get<double>();
        }
        return result;
    }

    std::string_view text_;
    std::string source_;
};

std::optional<std::string_view> built_in_text(const std::string& name) {
    return embedded::file(std::string(kLessonFolder) + name + ".json");
}

std::string folder_of(const std::string& file) { return std::filesystem::path(file).parent_path().string(); }

bool ends_in_json(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return ending == ".json";
}

// Whether the outermost object has the key "lesson"; all else is left to whoever reads it in earnest.
bool is_lesson_text(std::string_view text) {
    const std::optional<Json> root = read_json_or_nothing(text, kDeepest);
    return root && root->is_object() && root->contains("lesson");
}

}  // namespace

Lesson parse_lesson(std::string_view text, std::string_view source, const std::string& folder) {
    Lesson lesson = LessonReader(text, source).read();
    for (LessonStep& step : lesson.steps)
        if (MeshSurface* m = std::get_if<MeshSurface>(&step.scene.surface))
            m->mesh = (std::filesystem::path(folder) / m->mesh).lexically_normal().string();
    return lesson;
}

const std::vector<BuiltInLesson>& built_in_lessons() {
    static const std::vector<BuiltInLesson> lessons = [] {
        std::vector<BuiltInLesson> list;
        for (const std::string_view file : embedded::names()) {
            if (!file.starts_with(kLessonFolder) || !file.ends_with(".json")) continue;
            const std::string name(file.substr(kLessonFolder.size(), file.size() - kLessonFolder.size() - 5));
            // Only the head: checking every scene of every lesson is for whoever opens one.
            const Json head = Json::parse(*embedded::file(file), nullptr, false);
            list.push_back({name, head.value("lesson", name), head.value("about", "")});
        }
        std::ranges::sort(list, {}, &BuiltInLesson::name);
        return list;
    }();
    return lessons;
}

bool is_lesson(const std::string& file_or_name) {
    if (built_in_text(file_or_name)) return true;
    std::error_code ignored;
    if (!ends_in_json(file_or_name) || !std::filesystem::is_regular_file(file_or_name, ignored)) return false;
    if (std::filesystem::file_size(file_or_name, ignored) > kLargestLessonFile) return false;
    return is_lesson_text(read_file(file_or_name, kLargestLessonFile));
}

Lesson load_lesson(const std::string& file_or_name) {
    if (const auto text = built_in_text(file_or_name)) return parse_lesson(*text, file_or_name);
    if (ends_in_json(file_or_name))
        return parse_lesson(read_file(file_or_name, kLargestLessonFile), file_or_name, folder_of(file_or_name));
    std::string names;
    for (const BuiltInLesson& lesson : built_in_lessons()) names += (names.empty() ? "" : ", ") + lesson.name;
    throw InputError(file_or_name + ": no such lesson; there are " + names + ", and files that end in .json");
}

std::optional<LessonPlace> lesson_place(const std::string& file_or_name) {
    const auto mark = file_or_name.rfind('#');
    if (mark == std::string::npos || mark == 0) return std::nullopt;
    const std::string digits = file_or_name.substr(mark + 1);
    if (digits.empty() || digits.size() > 6 || digits.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    const std::string lesson = file_or_name.substr(0, mark);
    if (!is_lesson(lesson)) return std::nullopt;
    const std::size_t number = std::stoul(digits);
    const std::size_t steps = load_lesson(lesson).steps.size();
    if (number < 1 || number > steps)
        throw InputError(file_or_name + ": there is no such step; the lesson has steps 1 to " + std::to_string(steps));
    return LessonPlace{lesson, number - 1};
}

}  // namespace normalscope

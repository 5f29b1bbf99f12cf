#include "core/lessons/open.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_reading.h"
#include "core/base/nearest.h"
#include "core/base/overload.h"
#include "core/base/text.h"
#include "core/formula/parse.h"
#include "core/lessons/address.h"
#include "core/lessons/link.h"
#include "core/mesh/mesh_file.h"
#include "core/scene/scene_json.h"

#include <embedded.h>

#include <algorithm>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = std::size_t{16} << 20, kLargestLesson = std::size_t{4} << 20;
constexpr std::string_view kSceneFolder = "assets/scenes/";

std::string ending_of(const fs::path& file) { return in_small_letters(file.extension().string()); }

// Something like x^2+y^2-1; a name such as "cyl" is read as one, too, but was hardly meant.
bool is_formula(const std::string& text) {
    if (text.find_first_of("+*/^=²³") == std::string::npos) return false;
    try {
        formulas::Graph graph;
        (void)formulas::parse(graph, text);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

// The built-in scenes' names in one line: those of the gallery only where one of them was meant.
std::string names_like(std::string_view wanted) {
    const bool gallery = wanted.starts_with(kGalleryPrefix.substr(0, 4));
    std::string names;
    for (const BuiltInScene& scene : built_in_scenes())
        if (scene.name.starts_with(kGalleryPrefix) == gallery) names += (names.empty() ? "" : ", ") + scene.name;
    return gallery ? names : names + ", and others by \"normalscope scenes\"";
}

std::vector<std::string> lesson_names() {
    std::vector<std::string> names;
    for (const ListedLesson& lesson : built_in_lessons()) names.push_back(lesson.name);
    return names;
}

std::optional<std::string_view> scene_text_of(const std::string& name) {
    return embedded::file(std::string(kSceneFolder) + name + ".json");
}

[[noreturn]] void refuse(const std::string& name) {
    std::error_code ignored;
    if (fs::exists(name, ignored))
        throw InputError(name, "not a kind of file that is read; a scene or a lesson ends in .json, a mesh in " +
                                   mesh_endings_in_words(", ", " or "));
    if (is_formula(name))
        throw InputError(name, "no such file; a formula is given by --set 'surface.formula=" + name + "'");
    const std::vector<std::string> lessons = lesson_names();
    std::vector<std::string> names = lessons;
    for (const BuiltInScene& scene : built_in_scenes()) names.push_back(scene.name);
    if (const auto meant = nearest(name, names))
        throw InputError(name, "no such file, scene or lesson; did you mean " + *meant +
                                   "? The names are listed by \"normalscope scenes\" and \"normalscope lessons\"");
    throw InputError(
        name, "no such file, nor a built-in scene (" + names_like(name) + ") or lesson (" + joined(lessons) + ")");
}

// Whether the JSON is meant as a lesson; all else is left to whoever reads it in earnest.
bool is_lesson(const nlohmann::ordered_json& json) { return json.is_object() && json.contains("lesson"); }

Contents contents_of_json(std::string_view text, const std::string& name, const fs::path& folder) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw InputError(name, "is empty; it does not hold a scene");
    try {
        const nlohmann::ordered_json json = read_json(text);
        if (is_lesson(json)) {
            if (text.size() > kLargestLesson)
                throw InputError(name, "is larger than " + std::to_string(kLargestLesson >> 20) +
                                           " MiB, the most that is read of a lesson");
            return OpenedLesson{std::make_shared<const Lesson>(lesson_of_json(json, {text, name, folder})), {}};
        }
        Scene scene = scene_of_json(json);
        if (MeshSurface* m = std::get_if<MeshSurface>(&scene.surface))
            m->mesh = (folder / m->mesh).lexically_normal().generic_string();
        return scene;
    } catch (const JsonError& e) {
        throw InputError(name, e.what());
    }
}

Contents contents_of_standard_input() {
    const std::string text = read_standard_input(kLargestFile);
    if (is_link(text)) return scene_of_link(text);
    return contents_of_json(text, "standard input", {});
}

// "NAME#n", or of a built-in lesson "NAME/n", as addresses have it. Empty where NAME is nothing that could have steps: a
// file's name may have a # of its own.
std::optional<Contents> step_of(const std::string& name) {
    const auto slash = name.rfind('/');
    const bool as_in_address = slash != std::string::npos && is_built_in_lesson(name.substr(0, slash));
    const auto mark = as_in_address ? slash : name.rfind('#');
    if (mark == std::string::npos) return std::nullopt;
    const std::string whole = name.substr(0, mark), digits = name.substr(mark + 1);
    if (!is_built_in_lesson(whole) && ending_of(whole) != ".json") return std::nullopt;
    Contents contents = open_name(whole);
    auto* opened = std::get_if<OpenedLesson>(&contents);
    if (!opened) throw InputError(name, whole + " is a scene, which has no steps; leave out #" + digits);
    const std::size_t count = opened->lesson->steps.size();
    const bool number =
        !digits.empty() && digits.size() <= 6 && digits.find_first_not_of("0123456789") == std::string::npos;
    if (!number || std::stoul(digits) < 1 || std::stoul(digits) > count)
        throw InputError(name, "there is no such step; the lesson has steps 1 to " + std::to_string(count));
    opened->step = std::stoul(digits) - 1;
    return contents;
}

}  // namespace

Contents open_name(const std::string& name) {
    if (name.empty()) throw InputError("FILE", "its name is empty; give a file, or the name of a built-in scene");
    if (const auto named = name_of_address(name)) return open_name(*named);
    if (is_link(name)) return scene_of_link(name);
    if (const auto exercises = exercises_name(name)) return *exercises;
    if (name == "-") return contents_of_standard_input();
    if (is_mesh_file(name)) return MeshFile{name};
    if (ending_of(name) == ".json")
        return contents_of_json(read_file(name, kLargestFile), name, fs::path(name).parent_path());
    if (const auto text = scene_text_of(name)) return parse_scene(*text, name);
    if (is_built_in_lesson(name)) return OpenedLesson{std::make_shared<const Lesson>(built_in_lesson(name)), {}};
    if (std::optional<Contents> step = step_of(name)) return *std::move(step);
    refuse(name);
}

Scene first_scene(const Contents& contents) {
    return std::visit(
        Overload{[](const Scene& scene) { return scene; },
                 [](const MeshFile& mesh) { return with_mesh(load_scene(std::string(kDefaultScene)), mesh.file); },
                 [](const OpenedLesson& opened) { return opened.lesson->steps[opened.step.value_or(0)].scene; },
                 [](const ExercisesName& exercises) { return make_exercise(exercises.seed.value_or(0), 0).scene; }},
        contents);
}

Scene load_scene(const std::string& name) { return first_scene(open_name(name)); }

Lesson load_lesson(const std::string& name, std::string_view others) {
    if (!is_built_in_lesson(name) && ending_of(name) != ".json" && name != "-") {
        const std::vector<std::string> names = lesson_names();
        const auto meant = nearest(name, names);
        throw InputError(name, "no such lesson; " + (meant ? "did you mean " + *meant + "? There are " : "there are ") +
                                   joined(names) + std::string(others) + ", and files that end in .json");
    }
    const Contents contents = open_name(name);
    const auto* opened = std::get_if<OpenedLesson>(&contents);
    if (!opened) throw InputError(name, "is a scene, not a lesson, which has the keys lesson and steps");
    return *opened->lesson;
}

std::vector<Lesson> load_lessons(const std::string& name, std::string_view others) {
    if (name != "all") return {load_lesson(name, ", all" + std::string(others))};
    std::vector<Lesson> lessons;
    for (const ListedLesson& each : built_in_lessons()) lessons.push_back(built_in_lesson(each.name));
    return lessons;
}

Scene with_mesh(Scene scene, const std::string& file) {
    scene.about.clear();
    scene.surface = MeshSurface{file};
    scene.probe.reset();  // it was a point of another surface
    return scene;
}

Scene as_saved_in(Scene scene, const fs::path& file) {
    if (MeshSurface* m = std::get_if<MeshSurface>(&scene.surface)) {
        std::error_code error;
        const fs::path folder = fs::absolute(file, error).parent_path();
        const fs::path relative = fs::proximate(fs::absolute(m->mesh, error), folder, error);
        if (!error) m->mesh = relative.generic_string();  // which every system reads
    }
    return scene;
}

void save_scene(const Scene& scene, const fs::path& file) {
    write_file(file, scene_text(as_saved_in(scene, file)) + "\n");
}

bool is_built_in_scene(const std::string& name) { return scene_text_of(name).has_value(); }

std::vector<BuiltInScene> built_in_scenes() {
    std::vector<BuiltInScene> scenes;
    for (const std::string_view file : embedded::names()) {
        if (!file.starts_with(kSceneFolder) || !file.ends_with(".json")) continue;
        const std::string scene_name(file.substr(kSceneFolder.size(), file.size() - kSceneFolder.size() - 5));
        scenes.push_back({scene_name, parse_scene(*embedded::file(file), scene_name).about});
    }
    std::ranges::sort(scenes, {}, &BuiltInScene::name);
    return scenes;
}

}  // namespace normalscope

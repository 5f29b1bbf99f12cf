#include "core/lessons/open_scene.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/formula/parse.h"
#include "core/lessons/exercise.h"
#include "core/lessons/lesson.h"
#include "core/lessons/link.h"
#include "core/scene/scene_json.h"

#include <embedded.h>

#include <algorithm>
#include <cctype>

namespace normalscope {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSceneFile = std::size_t{16} << 20;
constexpr std::string_view kSceneFolder = "assets/scenes/";

std::string lower_case_ending(const fs::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

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

}  // namespace

bool is_mesh_file(const fs::path& file) {
    const std::string ending = lower_case_ending(file);
    return ending == ".obj" || ending == ".ply" || ending == ".stl";
}

Scene with_mesh(Scene scene, const std::string& file) {
    scene.about.clear();
    scene.surface = MeshSurface{file};
    scene.probe.reset();  // it was a point of another surface
    return scene;
}

Scene load_scene(const std::string& file_or_name) {
    if (is_link(file_or_name)) return scene_of_link(file_or_name);
    if (const auto exercises = exercises_name(file_or_name)) return make_exercise(exercises->seed.value_or(0), 0).scene;
    if (const auto place = lesson_place(file_or_name)) return load_lesson(place->lesson).steps[place->step].scene;
    if (is_lesson(file_or_name)) return load_lesson(file_or_name).steps.front().scene;
    const fs::path path(file_or_name);
    if (lower_case_ending(path) == ".json") {
        Scene scene = parse_scene(read_file(path, kLargestSceneFile), file_or_name);
        if (MeshSurface* m = std::get_if<MeshSurface>(&scene.surface))
            m->mesh = (path.parent_path() / m->mesh).lexically_normal().string();
        return scene;
    }
    if (is_mesh_file(path)) {
        Scene scene = with_mesh(load_scene(std::string(kDefaultScene)), file_or_name);
        scene.camera.zoom = 1.25;  // few meshes fill the ball that they touch
        return scene;
    }
    if (const auto text = embedded::file(std::string(kSceneFolder) + file_or_name + ".json"))
        return parse_scene(*text, file_or_name);

    std::error_code ignored;
    if (fs::exists(path, ignored))
        throw InputError(file_or_name +
                         ": its ending tells nothing; a scene ends in .json, a mesh in .obj, .ply or .stl");
    if (is_formula(file_or_name))
        throw InputError(file_or_name + ": no such file; a formula is given by --set 'surface.formula=" + file_or_name +
                         "'");
    std::string lessons;
    for (const BuiltInLesson& lesson : built_in_lessons()) lessons += (lessons.empty() ? "" : ", ") + lesson.name;
    throw InputError(file_or_name + ": no such file, nor a built-in scene (" + names_like(file_or_name) +
                     ") or lesson (" + lessons + ")");
}

void save_scene(const Scene& scene, const fs::path& file) {
    Scene portable = scene;
    if (MeshSurface* m = std::get_if<MeshSurface>(&portable.surface)) {
        std::error_code error;
        const fs::path folder = fs::absolute(file, error).parent_path();
        const fs::path relative = fs::proximate(fs::absolute(m->mesh, error), folder, error);
        if (!error) m->mesh = relative.string();
    }
    write_file(file, scene_text(portable) + "\n");
}

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

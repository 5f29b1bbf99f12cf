#include "viewer/opening.h"

#include "core/lessons/exercise.h"
#include "core/lessons/open_scene.h"
#include "core/mesh/mesh_file.h"

#include <random>
#include <set>
#include <variant>

namespace normalscope {

namespace {

// The steps' surfaces are made when they are reached, which must not fail in the middle of a lecture. Shapes and formulas
// have been checked as they were read; of a mesh file only its reader knows.
void read_meshes(const Lesson& lesson, const Scene& read) {
    std::set<std::string> files;
    if (const auto* surface = std::get_if<MeshSurface>(&read.surface)) files.insert(surface->mesh);
    for (const LessonStep& step : lesson.steps)
        if (const auto* surface = std::get_if<MeshSurface>(&step.scene.surface);
            surface && files.insert(surface->mesh).second)
            (void)load_mesh(surface->mesh);
}

}  // namespace

bool is_more_than_a_scene(const std::string& file) {
    return exercises_name(file).has_value() || is_lesson(file) || lesson_place(file).has_value();
}

Opened open_file(const std::string& file, const Scene& scene) {
    Opened opened{file, scene, std::make_unique<SurfaceCache>(), nullptr, std::nullopt, std::nullopt};
    if (const auto exercises = exercises_name(file)) {
        // Another set each time, of which people can tell each other the number.
        opened.exercises = exercises->seed.value_or(std::random_device{}() % 100000);
        return opened;
    }
    const auto place = lesson_place(file);
    if (place || is_lesson(file)) {
        opened.lesson = std::make_shared<const Lesson>(load_lesson(place ? place->lesson : file));
        if (place) opened.step = place->step;
        const Scene& first = opened.lesson->steps[opened.step.value_or(0)].scene;
        (void)opened.surfaces->get(first);
        read_meshes(*opened.lesson, first);
        return opened;
    }
    opened.scene = is_mesh_file(file) ? with_mesh(scene, file) : load_scene(file);
    (void)opened.surfaces->get(opened.scene);
    return opened;
}

}  // namespace normalscope

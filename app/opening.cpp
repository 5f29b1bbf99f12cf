#include "opening.h"

#include "core/exercise.h"
#include "core/scene_file.h"

#include <random>

namespace normalscope {

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
        // The steps' own surfaces are made when they are reached, but none that cannot be made.
        for (const LessonStep& step : opened.lesson->steps) (void)opened.surfaces->get(step.scene);
        return opened;
    }
    opened.scene = is_mesh_file(file) ? with_mesh(scene, file) : load_scene(file);
    (void)opened.surfaces->get(opened.scene);
    return opened;
}

}  // namespace normalscope

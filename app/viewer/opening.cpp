#include "viewer/opening.h"

#include "core/lessons/address.h"
#include "core/lessons/link.h"
#include "core/lessons/open.h"
#include "core/mesh/mesh_file.h"
#include "core/picture/framing.h"

#include <random>
#include <variant>

namespace normalscope {

namespace {

// The steps' surfaces are made when they are reached. Shapes and formulas have been checked as they were read; of a mesh file
// only its reader knows.
void read_meshes_of_steps(const Opened& opened) {
    for (const std::string& file : meshes_of(opened))
        if (const auto* first = std::get_if<MeshSurface>(&opened.scene.surface); !first || first->mesh != file)
            (void)load_mesh(file);
}

}  // namespace

std::set<std::string> meshes_of(const Opened& opened) {
    std::set<std::string> files;
    const auto add = [&](const Scene& scene) {
        if (const auto* surface = std::get_if<MeshSurface>(&scene.surface)) files.insert(surface->mesh);
    };
    add(opened.scene);
    if (opened.lesson)
        for (const LessonStep& step : opened.lesson->steps) add(step.scene);
    return files;
}

Opened read_file(const std::string& file, const Scene& scene) {
    if (const auto named = name_of_address(file)) return read_file(*named, scene);
    Opened opened{.file = is_link(file) || file == "-" ? "" : file, .scene = scene};
    const Contents contents = open_name(file);
    if (const auto* exercises = std::get_if<ExercisesName>(&contents)) {
        // Another set each time, of which people can tell each other the number.
        opened.exercises = exercises->seed.value_or(std::random_device{}() % 100000);
        return opened;
    }
    if (const auto* mesh = std::get_if<MeshFile>(&contents))
        opened.scene = with_mesh(scene, mesh->file);
    else
        opened.scene = first_scene(contents);
    if (const auto* lesson = std::get_if<OpenedLesson>(&contents)) {
        opened.lesson = lesson->lesson;
        opened.step = lesson->step;
    }
    return opened;
}

void prepare(Opened& opened) {
    const std::shared_ptr<const Surface> surface = opened.surfaces->get(opened.scene);
    // Once, and not again with each change: what grows would always fill the picture.
    opened.scene = with_zoom(std::move(opened.scene), *surface);
    read_meshes_of_steps(opened);
}

Opened open_file(const std::string& file, const Scene& scene) {
    Opened opened = read_file(file, scene);
    prepare(opened);
    return opened;
}

}  // namespace normalscope

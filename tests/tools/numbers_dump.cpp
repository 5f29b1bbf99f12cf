// numbers_dump: what `--numbers` says of every built-in scene and of every lesson's step, to be held against what another
// processor says.

#include "core/explain/numbers_json.h"
#include "core/lessons/lesson.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"

#include <iostream>
#include <string>

namespace {

using namespace normalscope;

void dump(const std::string& name, const Scene& scene, SurfaceCache& surfaces) {
    const Frame frame = make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {1280, 720}}, .pixel_scale = 1.0f});
    std::cout << name << ' ' << numbers_text(scene, frame, {});
}

}  // namespace

int main() {
    SurfaceCache surfaces;
    for (const BuiltInScene& scene : built_in_scenes()) dump(scene.name, load_scene(scene.name), surfaces);
    for (const ListedLesson& lesson : built_in_lessons())
        for (const LessonStep& step : built_in_lesson(lesson.name).steps) dump(lesson.name, step.scene, surfaces);
}

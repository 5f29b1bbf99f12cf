#include "commands/scene_arguments.h"

#include "core/base/error.h"
#include "core/lessons/lesson.h"
#include "core/lessons/open_scene.h"
#include "core/scene/scene_json.h"

namespace normalscope {

Scene with_settings(Scene scene, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) scene = with_setting(scene, setting);
    return scene;
}

Scene scene_for(const std::string& file, const std::vector<std::string>& settings) {
    return with_settings(load_scene(file), settings);
}

CaptureOptions capture_options(const PictureArguments& arguments, bool numbers) {
    const auto place = arguments.captions ? lesson_place(arguments.file) : std::nullopt;
    if (arguments.captions && !place)
        throw UsageError("--captions: FILE must be a lesson's step, such as 1-normal-as-a-point#3");
    CaptureOptions options{.size = arguments.size,
                           .samples = arguments.samples,
                           .ground = arguments.ground,
                           .scale = arguments.scale,
                           .panel = arguments.panel || !arguments.tab.empty(),
                           .tab = arguments.tab,
                           .numbers = numbers};
    if (place) {
        options.lesson = std::make_shared<const Lesson>(load_lesson(place->lesson));
        options.step = place->step;
    }
    return options;
}

}  // namespace normalscope

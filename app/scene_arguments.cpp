#include "scene_arguments.h"

#include "core/scene_file.h"
#include "core/scene_json.h"

namespace normalscope {

Scene with_settings(Scene scene, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) scene = with_setting(scene, setting);
    return scene;
}

Scene scene_for(const std::string& file, const std::vector<std::string>& settings) {
    return with_settings(load_scene(file), settings);
}

CaptureOptions capture_options(const PictureArguments& arguments, bool numbers) {
    return {.size = arguments.size,
            .samples = arguments.samples,
            .scale = arguments.scale,
            .panel = arguments.panel || !arguments.tab.empty(),
            .tab = arguments.tab,
            .numbers = numbers};
}

}  // namespace normalscope

#include "viewer/copied_command.h"

#include "core/base/decimal.h"
#include "core/base/error.h"
#include "core/base/system.h"
#include "core/frame/display_scale.h"
#include "core/lessons/open.h"
#include "core/scene/setting.h"

#include <cmath>

namespace normalscope {

std::string capture_command(const Scene& scene, const Origin& origin, glm::ivec2 size, float scale) {
    const std::string& file = origin.file;
    std::string command = "normalscope capture";
    Scene base;
    try {
        base = load_scene(file.empty() ? std::string(kDefaultScene) : file);
        if (!file.empty()) command += " " + shell_word(file);
    } catch (const InputError&) {  // it is there no longer
        base = load_scene(std::string(kDefaultScene));
    }
    // Where it says no zoom, it was framed as a capture frames it.
    if (!base.camera.zoom && scene.camera.zoom == origin.saved.camera.zoom) base.camera.zoom = scene.camera.zoom;
    command += " -o picture.png --size " + std::to_string(size.x) + "x" + std::to_string(size.y);
    if (std::abs(scale - usual_scale(size)) > 1e-3f)
        command += " --scale " + with_digits(static_cast<double>(scale), 4);
    for (const Setting& setting : settings_between(base, scene)) command += " --set " + shell_word(setting.text());
    return command;
}

}  // namespace normalscope

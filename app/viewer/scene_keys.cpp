#include "viewer/scene_keys.h"

#include <GLFW/glfw3.h>

namespace normalscope {

bool press_view_key(Scene& scene, int key) {
    const auto look = [&](double azimuth, double elevation) {
        scene.camera.azimuth = azimuth;
        scene.camera.elevation = elevation;
        return true;
    };
    switch (key) {
        case GLFW_KEY_1: return look(0.0, 0.0);
        case GLFW_KEY_2: return look(90.0, 0.0);
        case GLFW_KEY_3: return look(0.0, 90.0);
        case GLFW_KEY_T: scene.theme = toggled(scene.theme); return true;
        default: return false;
    }
}

bool press_object_key(Scene& scene, int key) {
    switch (key) {
        case GLFW_KEY_N: scene.rule = Rule::Naive; return true;
        case GLFW_KEY_I: scene.rule = Rule::InverseTranspose; return true;
        case GLFW_KEY_C: scene.rule = Rule::Cofactor; return true;
        case GLFW_KEY_V: scene.view = static_cast<ViewMode>((static_cast<int>(scene.view) + 1) % 3); return true;
        case GLFW_KEY_E:
            scene.color = scene.color == SurfaceColor::Lit ? SurfaceColor::Error : SurfaceColor::Lit;
            return true;
        case GLFW_KEY_G: scene.show.ghost = !scene.show.ghost; return true;
        case GLFW_KEY_R: scene.stack = {Scale{}}; return true;
        default: return false;
    }
}

}  // namespace normalscope

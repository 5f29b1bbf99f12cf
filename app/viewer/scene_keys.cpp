#include "viewer/scene_keys.h"

namespace normalscope {

bool press_view_key(Scene& scene, ImGuiKey key) {
    const auto look = [&](double azimuth, double elevation) {
        scene.camera.azimuth = azimuth;
        scene.camera.elevation = elevation;
        return true;
    };
    switch (key) {
        case ImGuiKey_1: return look(0.0, 0.0);
        case ImGuiKey_2: return look(90.0, 0.0);
        case ImGuiKey_3: return look(0.0, 90.0);
        case ImGuiKey_T: scene.theme = toggled(scene.theme); return true;
        default: return false;
    }
}

bool press_object_key(Scene& scene, ImGuiKey key) {
    switch (key) {
        case ImGuiKey_N: scene.rule = Rule::Naive; return true;
        case ImGuiKey_I: scene.rule = Rule::InverseTranspose; return true;
        case ImGuiKey_C: scene.rule = Rule::Cofactor; return true;
        case ImGuiKey_V: scene.view = static_cast<ViewMode>((static_cast<int>(scene.view) + 1) % 3); return true;
        case ImGuiKey_E:
            scene.color = scene.color == SurfaceColor::Lit ? SurfaceColor::Error : SurfaceColor::Lit;
            return true;
        case ImGuiKey_G: scene.show.ghost = !scene.show.ghost; return true;
        case ImGuiKey_R: scene.stack = {Scale{}}; return true;
        default: return false;
    }
}

}  // namespace normalscope

#include "viewer/scene_keys.h"

#include "core/picture/drawn_arrows.h"

namespace normalscope {

namespace {

bool choose(Scene& scene, Rule rule) {
    if (can_choose(scene, rule)) scene.rule = rule;
    return true;
}

}  // namespace

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
        case ImGuiKey_N: return choose(scene, Rule::Naive);
        case ImGuiKey_I: return choose(scene, Rule::InverseTranspose);
        case ImGuiKey_C: return choose(scene, Rule::Cofactor);
        case ImGuiKey_V: scene.view = static_cast<ViewMode>((static_cast<int>(scene.view) + 1) % 3); return true;
        case ImGuiKey_E: scene.color = static_cast<SurfaceColor>((static_cast<int>(scene.color) + 1) % 3); return true;
        case ImGuiKey_G: scene.show.ghost = !scene.show.ghost; return true;
        case ImGuiKey_R: scene.stack = {Scale{}}; return true;
        default: return false;
    }
}

}  // namespace normalscope

#include "viewer/scene_keys.h"

namespace normalscope {

std::optional<Rule> rule_of(ImGuiKey key) {
    switch (key) {
        case ImGuiKey_N: return Rule::Naive;
        case ImGuiKey_I: return Rule::InverseTranspose;
        case ImGuiKey_C: return Rule::Cofactor;
        default: return std::nullopt;
    }
}

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
        case ImGuiKey_V: scene.view = static_cast<ViewMode>((static_cast<int>(scene.view) + 1) % 4); return true;
        case ImGuiKey_E: scene.color = static_cast<SurfaceColor>((static_cast<int>(scene.color) + 1) % 3); return true;
        case ImGuiKey_G: scene.show.ghost = !scene.show.ghost; return true;
        case ImGuiKey_O: scene.show.polygon = !scene.show.polygon; return true;
        case ImGuiKey_R: scene.stack = {Scale{}}; return true;
        default: return false;
    }
}

}  // namespace normalscope

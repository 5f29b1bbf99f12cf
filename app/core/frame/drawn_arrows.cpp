#include "core/frame/drawn_arrows.h"

#include "core/scene/mistakes.h"

#include <algorithm>

namespace normalscope {

std::vector<ArrowKind> drawn_arrows(const Scene& scene, const Transform<World, Object>& world_from_object,
                                    Rule pane_rule) {
    std::vector<ArrowKind> kinds = shown_arrows(scene, pane_rule);
    const NormalMatrices& matrices = world_from_object.normal_matrices_by_rule();
    const bool only_cofactor = world_from_object.affine() && matrices.rank == 2;
    if (only_cofactor && !scene.arrows.show && std::ranges::count(kinds, ArrowKind::InverseTranspose) > 0 &&
        std::ranges::count(kinds, ArrowKind::Cofactor) == 0)
        kinds.push_back(ArrowKind::Cofactor);
    return kinds;
}

std::vector<Rule> pane_rules(const Scene& scene) {
    if (scene.view != ViewMode::Split) return {scene.rule};
    return {Rule::Naive, scene.rule == Rule::Naive ? Rule::InverseTranspose : scene.rule};
}

bool can_choose(const Scene& scene, Rule rule) {
    // What the tangents go by is said by the rule alone.
    return scene.view != ViewMode::Split || rule != Rule::Naive || about_tangents(scene.mistake);
}

}  // namespace normalscope

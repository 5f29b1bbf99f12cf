#include "core/scene/scene.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

std::vector<ArrowKind> shown_arrows(const Scene& scene, Rule pane_rule) {
    if (scene.view == ViewMode::Split) {  // each pane argues for its own rule
        std::vector<ArrowKind> kinds{arrow_kind(pane_rule)};
        if (!scene.arrows.show) return kinds;
        std::erase_if(kinds, [&](ArrowKind k) { return std::ranges::count(*scene.arrows.show, k) == 0; });
        if (std::ranges::count(*scene.arrows.show, ArrowKind::Object)) kinds.push_back(ArrowKind::Object);
        return kinds;
    }
    if (scene.arrows.show) return *scene.arrows.show;
    if (scene.view == ViewMode::Single) return {arrow_kind(pane_rule)};
    if (pane_rule == Rule::Cofactor)
        return {ArrowKind::Object, ArrowKind::Naive, ArrowKind::InverseTranspose, ArrowKind::Cofactor};
    return {ArrowKind::Object, ArrowKind::Naive, ArrowKind::InverseTranspose};
}

std::vector<StackEntry> applied_stack(const Scene& scene) {
    if (!scene.stack_position || *scene.stack_position >= static_cast<double>(scene.stack.size())) return scene.stack;
    const auto whole = static_cast<std::size_t>(*scene.stack_position);
    std::vector<StackEntry> applied(scene.stack.begin(), scene.stack.begin() + static_cast<std::ptrdiff_t>(whole));
    const double part = *scene.stack_position - static_cast<double>(whole);
    if (part > 0.0) applied.push_back(partly(scene.stack[whole], part));
    return applied;
}

Transform<World, Object> world_from_object(const Scene& scene) {
    const std::vector<StackEntry> stack = applied_stack(scene);
    const glm::dmat4 m = product(stack);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!(std::abs(m[c][r]) < 1e60))
                throw InputError("stack", "the numbers in the product of its " + std::to_string(scene.stack.size()) +
                                              " entries must stay below 1e60; use smaller scales or fewer entries");
    return Transform<World, Object>(m, known_rank(stack));
}

}  // namespace normalscope

#pragma once

#include "core/scene/scene.h"

#include <algorithm>
#include <optional>

namespace normalscope {

/// The arrows of a rule that has just been chosen, on their way to where it wants them: the naive rule's come from the
/// right place, the inverse transpose's from the naive one. Only pictures know of it; the scene has arrived.
class Swing {
public:
    static constexpr double kSeconds = 1.0 / 3.0;

    /// What is chosen in `scene`, at `now` on any clock. Empty where nothing would be seen to move.
    static std::optional<Swing> to(Rule rule, const Scene& scene, double now) {
        if (rule == Rule::Cofactor || scene.mistake != Mistake::Naive) return std::nullopt;
        if (const auto m = world_from_object(scene); !m.affine() || m.rank() < 3) return std::nullopt;
        const bool naive = scene.rule == Rule::Naive;
        const double here = naive && scene.power < 1.0 ? scene.power : -1.0;
        if (rule == Rule::Naive) return Swing(rule, {here, -1.0}, now);
        return Swing(rule, {scene.power, naive ? scene.power : 1.0}, now);
    }

    /// The powers of both rules (between_the_rules).
    struct Powers {
        double naive = 1.0, right = -1.0;
    };
    /// Empty where it is over, or where the scene is no longer what was chosen.
    std::optional<Powers> at(double now, const Scene& scene) const {
        if (scene.rule != rule_ || !plainly(scene) || now - began_ >= kSeconds) return std::nullopt;
        const double t = std::clamp((now - began_) / kSeconds, 0.0, 1.0), done = t * t * (3.0 - 2.0 * t);
        return Powers{from_.naive + (1.0 - from_.naive) * done, from_.right + (-1.0 - from_.right) * done};
    }

private:
    Swing(Rule rule, Powers from, double now) : rule_(rule), from_(from), began_(now) {}
    static bool plainly(const Scene& scene) { return scene.mistake == Mistake::Naive && scene.power == 1.0; }

    Rule rule_;
    Powers from_;
    double began_;
};

}  // namespace normalscope

#pragma once

#include "core/math/normal_map.h"
#include "core/scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace normalscope {

/// The map that a rule stands for in this scene; empty where the rule gives no normal at all. For Rule::Naive it is
/// the scene's mistake, or the naive rule bent to the scene's power; `right_power` bends the inverse transpose, as while
/// its arrows swing to their place (between_the_rules).
std::optional<NormalMap> normal_map(const Scene& scene, const Transform<World, Object>& world_from_object, Rule rule,
                                    double right_power = -1.0);

/// The 3×3 matrix that the scene sends tangents through in place of M, where its mistake is about tangents and is shown.
std::optional<glm::dmat3> mistaken_tangents(const Scene& scene, const Transform<World, Object>& world_from_object);

/// A mistake's short title, what it looks like as a formula, and why it is one: for labels and for the panel.
struct MistakeText {
    std::string_view title, formula, reason;
};
MistakeText text(Mistake mistake);

/// What stands in the naive rule's place, in words: the scene's mistake, or the naive rule bent to the scene's power.
struct InNaivePlace {
    std::string title, formula, reason;
};
InNaivePlace in_naive_place(const Scene& scene);
/// Nothing but the naive rule stands in its place.
constexpr bool plainly_naive(const Scene& scene) { return scene.mistake == Mistake::Naive && scene.power == 1.0; }

/// What gives `rule`'s normals in this scene, short enough for a table: "M n", "M (n, 1)", …
std::string normal_formula(Rule rule, const Scene& scene);
/// Whether the mistake is about tangents: then the normals are right, and what they are held against is not.
constexpr bool about_tangents(Mistake mistake) {
    return mistake == Mistake::TangentsByInverseTranspose || mistake == Mistake::TangentsByCofactor;
}

}  // namespace normalscope

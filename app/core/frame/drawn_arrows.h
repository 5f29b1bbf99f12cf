#pragma once

#include "core/math/transform.h"
#include "core/scene/scene.h"

#include <vector>

namespace normalscope {

/// The arrows that a view draws for the rule that shades it: shown_arrows; and the cofactor's where it alone gives a normal,
/// beside the inverse transpose's that does not exist.
std::vector<ArrowKind> drawn_arrows(const Scene& scene, const Transform<World, Object>& world_from_object,
                                    Rule pane_rule);

/// The rules of a picture's panes, from left to right. In the split view the left one argues for the naive rule, the right
/// one for the chosen rule or, where that is naive, for the inverse transpose.
std::vector<Rule> pane_rules(const Scene& scene);

/// Whether choosing a rule would change anything: in the split view the naive one stands at the left in any case.
bool can_choose(const Scene& scene, Rule rule);

}  // namespace normalscope

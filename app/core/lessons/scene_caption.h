#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace normalscope {

/// A scene in a sentence and an equation or two, for a room that looks at it without a panel.
struct SceneSaid {
    std::string caption;
    std::vector<std::string> equations;
};
SceneSaid said_of(const Scene& scene);
/// What its M does to normals by the naive rule, in a sentence.
std::string said_of_m(const Scene& scene);

}  // namespace normalscope

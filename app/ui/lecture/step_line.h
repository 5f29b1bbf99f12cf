#pragma once

#include "core/frame/carried_arrows.h"
#include "core/lessons/lesson.h"
#include "core/lessons/tabs.h"

#include <optional>

namespace normalscope {

static_assert(kLinesWithArrows == kDerivationLines);

/// The line of the derivation whose arrows a step's picture shows.
inline std::optional<DerivationAt> line_of(const LessonStep& step) {
    if (!step.line) return std::nullopt;
    // The second tangent: of the shapes it is the one that goes up, which is seen from all around.
    return DerivationAt{.line = static_cast<DerivationLine>(*step.line), .tangent = 1};
}

}  // namespace normalscope

#pragma once

#include "core/frame/carried_arrows.h"
#include "core/math/highlight.h"
#include "core/math/point_label.h"

#include <optional>
#include <vector>

namespace normalscope {

/// What a lesson's step shows beyond its scene.
struct StepMarks {
    std::optional<DerivationAt> line;    ///< of the derivation, in place of the rules' arrows
    std::optional<Highlight> highlight;  ///< what stands out, while the other arrows are muted
    std::vector<PointLabel> labels;
    friend bool operator==(const StepMarks&, const StepMarks&) = default;
};

}  // namespace normalscope

#pragma once

#include "core/frame/step_marks.h"
#include "core/lessons/lesson.h"
#include "core/lessons/tabs.h"

namespace normalscope {

static_assert(kLinesWithArrows == kDerivationLines);

/// What the step's picture shows beyond its scene.
inline StepMarks marks_of(const LessonStep& step) {
    StepMarks marks{.line = {}, .highlight = step.highlight, .labels = step.labels};
    // The second tangent: of the shapes it is the one that goes up, which is seen from all around.
    if (step.line) marks.line = DerivationAt{.line = static_cast<DerivationLine>(*step.line), .tangent = 1};
    if (marks.highlight) marks.highlight->tangent = 1;
    return marks;
}

}  // namespace normalscope

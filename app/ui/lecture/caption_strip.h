#pragma once

#include "core/lessons/lesson.h"
#include "ui/kit/style.h"
#include "ui/typeset/math_box.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

/// What is said below the picture: in a lesson, or by a lecturer.
struct Speech {
    std::string caption, look_at;
    std::vector<std::string> equations;
    std::optional<Question> question;
    friend bool operator==(const Speech&, const Speech&) = default;
};
Speech speech_of(const LessonStep& step);

struct StripAction {
    const char *label, *about;
    bool enabled = true;
};
/// What stands beside it, and what may be done.
struct StripState {
    std::string title;
    std::size_t number = 0, count = 0;  ///< the step, from 0; no steps: nothing to go through
    std::optional<std::size_t> answer;  ///< the choice made last
    bool strayed = false;               ///< the scene is no longer the step's
    bool closes = false;                ///< it can be left
    bool goes_on = false;               ///< after the last step, too
    std::vector<StripAction> actions;
    bool recorded = false;  ///< a picture of it is made: there is nothing to press
};
struct StripRequests {
    bool next = false, previous = false, again = false, close = false;
    std::optional<std::size_t> choose, action;
};

/// The strip below the picture that says it.
class CaptionStrip {
public:
    /// As high as the highest of these needs, so that the picture keeps its size from step to step; at most `most`.
    float height(const Look& look, std::span<const Speech> speeches, float width, float most);

    StripRequests draw(const Look& look, const Speech& speech, const StripState& state, ImVec2 low, ImVec2 size);

    /// What was measured holds for its fonts only.
    void forget_layout() { measured_.reset(); }

private:
    struct Measured {
        std::vector<Speech> speeches;
        float width = 0.0f, height = 0.0f;
    };
    std::optional<Measured> measured_;
};

}  // namespace normalscope

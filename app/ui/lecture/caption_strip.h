#pragma once

#include "ui/kit/style.h"
#include "ui/lecture/strip_layout.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace normalscope {

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
    const char* next = nullptr;         ///< what its button does; none: nothing
    std::vector<StripAction> actions;
    bool recorded = false;    ///< a picture of it is made: there is nothing to press
    std::string short_title;  ///< where there is no room for the other; empty: its beginning
};
struct StripRequests {
    bool next = false, previous = false, again = false, close = false;
    std::optional<std::size_t> choose, action;
};

struct StripRoom {
    ImVec2 low, size;
    StripPlace::Side side = StripPlace::Side::Below;
};

/// The strip below or beside the picture that says it, with the board on which the equations stay.
class CaptionStrip {
public:
    /// As strip_place has it.
    StripPlace place(const Look& look, std::span<const Speech> lesson, std::span<const Speech> held, ImVec2 room);

    StripRequests draw(const Look& look, const Speech& speech, const StripState& state, const StripRoom& room);

    /// What was measured holds for its fonts only.
    void forget_layout() { measured_.reset(); }

private:
    struct Measured {
        std::vector<Speech> lesson, held;
        ImVec2 room;
        StripPlace place;
    };
    std::optional<Measured> measured_;

    // What is scrolled to: the beginning of what is said, and the end once an answer is explained there.
    Speech said_;
    std::optional<std::size_t> explained_;
};

}  // namespace normalscope

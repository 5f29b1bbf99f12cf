#include "viewer/viewer.h"

#include <glm/common.hpp>

#include <string_view>

namespace normalscope {

namespace {

constexpr double kQuietly = 0.3;  // seconds until it is said that a surface is being made
constexpr std::string_view kMaking = "Computing the surface \u2026  Esc cancels";

constexpr std::string_view kLost = "Press F to see the whole object";

// Of the object, or of the box around it in the picture.
bool mostly_outside(const Frame& frame) {
    constexpr double kSeen = 0.6;
    for (const Pane& pane : frame.panes) {
        if (pane.outline.empty()) continue;
        glm::dvec2 low = pane.outline.front(), high = low;
        for (const glm::dvec2& p : pane.outline) low = glm::min(low, p), high = glm::max(high, p);
        const glm::dvec2 inside = glm::min(high, glm::dvec2(pane.rect.size)) - glm::max(low, glm::dvec2(0.0)),
                         whole = high - low;
        if (!(inside.x >= 0.0 && inside.y >= 0.0 && inside.x * inside.y >= kSeen * whole.x * whole.y)) return true;
    }
    return false;
}

}  // namespace

void Viewer::tell_of_waiting() {
    if (!surfaces_.making()) {
        waiting_since_ = host_.now();
        gui_.interface.take_back_note(kMaking);
    } else if (host_.now() - waiting_since_ >= kQuietly) {
        gui_.interface.show_note(kMaking);
    }
}

void Viewer::tell_of_lost_object() {
    const Camera& camera = document_.scene.camera;
    if (const bool lost = mostly_outside(*frame_); !lost || in_lesson() || exercising()) {
        seen_by_ = camera;
        gui_.interface.take_back_note(kLost);
    } else if (seen_by_ == camera && !pointer_.busy()) {
        seen_by_.reset();  // said once
        gui_.interface.show_note(kLost);
    }
}

bool Viewer::give_up_surface() {
    if (!surfaces_.making()) return false;
    gui_.finish_typing();
    commit();
    surfaces_.stop_making();
    if (document_.can_undo()) {
        document_.undo();
        follow_draft();
        gui_.interface.show_note("Cancelled; Ctrl+Y tries again");
    }
    return true;
}

}  // namespace normalscope

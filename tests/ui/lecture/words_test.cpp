// What is written in a lesson's pictures hides nothing that it explains.
#include "core/frame/display_scale.h"
#include "core/frame/label_room.h"
#include "core/lessons/open.h"
#include "core/picture/make_frame.h"
#include "core/surface/surface.h"
#include "ui/offscreen_gui.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace normalscope {
namespace {

struct Line {
    glm::dvec2 a, b;
};

// Every edge of every triangle that an arrow, an arc or a line is made of, as the picture has it, and what the pane says of
// them itself: a flat view is made of nothing but flat shapes.
std::vector<Line> drawn_lines(const Frame& frame) {
    std::vector<Line> lines;
    for (const Pane& pane : frame.panes) {
        const glm::dvec2 origin(pane.rect.origin);
        const auto add = [&](const glm::dvec3& a, const glm::dvec3& b) {
            const glm::dvec3 from = pane.view.pixel({a}), to = pane.view.pixel({b});
            if (from.z > 0.0 && to.z > 0.0) lines.push_back({origin + glm::dvec2(from), origin + glm::dvec2(to)});
        };
        for (std::size_t i = 0; i + 2 < pane.solids.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k) {
                const SolidVertex &a = pane.solids[i + k], &b = pane.solids[i + (k + 1) % 3];
                if (glm::length(a.normal) > 0.0f) add(a.position, b.position);
            }
        for (const ArrowDraw& draw : pane.arrows)
            for (const Site& site : frame.surface->arrows)
                if (const auto ends = ends_of(draw, site)) add((*ends)[0], (*ends)[1]);
        for (const Stroke& stroke : pane.strokes) add(stroke.a, stroke.b);
    }
    return lines;
}

// Of the step as it is presented; empty: they lie on nothing.
std::string what_words_hide(const std::shared_ptr<const Lesson>& lesson, std::size_t step, glm::ivec2 room,
                            SurfaceCache& surfaces) {
    OffscreenGui gui;
    const Scene& scene = lesson->steps[step].scene;
    gui.interface.record_lesson(lesson, scene, step, std::nullopt);
    const float scale = DisplayScale{}.of(1.0f, room, true);
    gui.interface.prepare(scene.theme, scale);
    const Frame frame = make_frame(
        scene, surfaces.get(scene),
        {.rect = gui.interface.picture(room), .pixel_scale = scale, .handles = false, .marks = gui.interface.marks()});
    const std::vector<Line> lines = drawn_lines(frame);
    std::string hidden;
    const glm::dvec2 low(frame.rect.origin), high = low + glm::dvec2(frame.rect.size);
    for (const Line& line : lines)
        for (const glm::dvec2& end : {line.a, line.b})
            if (hidden.empty() && (glm::any(glm::lessThan(end, low)) || glm::any(glm::lessThan(high, end))))
                hidden = "an arrow or a line beyond the picture's edge; ";
    for (const PixelRect& box : gui.interface.word_boxes(frame)) {
        const glm::dvec2 half = 0.5 * glm::dvec2(box.size), middle = glm::dvec2(box.origin) + half;
        for (const Line& line : lines)
            if (length_within(half, line.a - middle, line.b - middle) > 0.0) {
                hidden += "words at " + std::to_string(box.origin.x) + ", " + std::to_string(box.origin.y) + ", " +
                          std::to_string(box.size.x) + " by " + std::to_string(box.size.y) + "; ";
                break;
            }
    }
    return hidden;
}

TEST(WordsOfALesson, LieOnNoArrow) {
    SurfaceCache surfaces;
    for (const ListedLesson& listed : built_in_lessons()) {
        const auto lesson = std::make_shared<const Lesson>(load_lesson(listed.name));
        for (std::size_t i = 0; i < lesson->steps.size(); ++i)
            for (const glm::ivec2 room : {glm::ivec2(1024, 768), glm::ivec2(1920, 1080), glm::ivec2(3840, 2160)})
                EXPECT_EQ(what_words_hide(lesson, i, room, surfaces), "")
                    << listed.name << "#" << i + 1 << " at " << room.x << "x" << room.y;
    }
}

}  // namespace
}  // namespace normalscope

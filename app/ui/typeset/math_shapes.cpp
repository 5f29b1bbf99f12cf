#include "ui/typeset/math_shapes.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

float share(const Pen& pen, float of_em) { return std::round(of_em * pen.em); }

}  // namespace

// By way of two points between: where points fall together Dear ImGui draws a line twice as wide.
MathBox::Stroke straight(const Pen& pen, ImVec2 a, ImVec2 b) {
    const auto between = [&](float t) { return ImVec2(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)); };
    return {{a, between(1.0f / 3.0f), between(2.0f / 3.0f), b}, false, pen.weight, pen.ink};
}

MathBox fraction_box(const Pen& pen, const MathBox& over, const MathBox& under) {
    MathBox box;
    const float pad = share(pen, 0.08f), y = -std::round(0.34f * pen.em);
    const float width = std::max(over.width, under.width) + 2 * pad;
    box.add(over, std::round((width - over.width) / 2), y - share(pen, 0.12f) - over.descent);
    box.add(under, std::round((width - under.width) / 2), y + share(pen, 0.14f) + under.ascent);
    box.width = width;
    box.strokes.push_back(straight(pen, {0, y}, {width, y}));
    return box;
}

MathBox root_box(const Pen& pen, const MathBox& inside) {
    MathBox box;
    const float wide = share(pen, 0.55f), top = -inside.ascent - share(pen, 0.12f), low = inside.descent;
    box.add(inside, wide + share(pen, 0.06f));
    box.width += share(pen, 0.1f);
    box.ascent = std::max(box.ascent, -top + pen.weight);
    box.strokes.push_back({{ImVec2(share(pen, 0.05f), top * 0.35f), ImVec2(share(pen, 0.17f), top * 0.42f),
                            ImVec2(share(pen, 0.32f), low), ImVec2(wide, top)},
                           false,
                           pen.weight,
                           pen.ink});
    box.strokes.push_back(straight(pen, {wide, top}, {box.width, top}));
    return box;
}

}  // namespace normalscope

#include "ui/kit/icons.h"

#include "core/frame/solids.h"

#include <array>
#include <cmath>
#include <numbers>

namespace normalscope {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Strokes in a square from −1 to 1, y downward.
class Pen {
public:
    Pen(ImDrawList& list, ImVec2 centre, float side, ImU32 color)
        : list_{list}, centre_{centre}, half_{side / 2}, color_{color}, weight_{std::max(1.0f, side * 0.085f)} {}

    ImVec2 at(float x, float y) const { return {centre_.x + x * half_, centre_.y + y * half_}; }
    template <std::size_t N>
    void path(const std::array<ImVec2, N>& points, bool closed = false) {
        for (const ImVec2& p : points) list_.PathLineTo(at(p.x, p.y));
        list_.PathStroke(color_, closed ? ImDrawFlags_Closed : 0, weight_);
    }
    void line(float x0, float y0, float x1, float y1) { list_.AddLine(at(x0, y0), at(x1, y1), color_, weight_); }
    void box(float x0, float y0, float x1, float y1, float rounding = 0.15f) {
        list_.AddRect(at(x0, y0), at(x1, y1), color_, rounding * half_, 0, weight_);
    }
    void circle(float x, float y, float r) { list_.AddCircle(at(x, y), r * half_, color_, 0, weight_); }
    void dot(float x, float y, float r) { list_.AddCircleFilled(at(x, y), r * half_, color_); }
    void arc(float x, float y, float r, float from, float to) {
        list_.PathArcTo(at(x, y), r * half_, from, to);
        list_.PathStroke(color_, 0, weight_);
    }

private:
    ImDrawList& list_;
    ImVec2 centre_;
    float half_;
    ImU32 color_;
    float weight_;
};

// A turn back, or forward when mirrored.
void turn(Pen& pen, float mirror) {
    pen.path(std::array{ImVec2(mirror * -0.25f, -0.8f), ImVec2(mirror * -0.7f, -0.35f), ImVec2(mirror * -0.25f, 0.1f)});
    pen.line(mirror * -0.7f, -0.35f, mirror * 0.2f, -0.35f);
    if (mirror > 0)
        pen.arc(0.2f, 0.15f, 0.5f, -kPi / 2, kPi / 2);
    else
        pen.arc(-0.2f, 0.15f, 0.5f, -kPi / 2, -3 * kPi / 2);
    pen.line(mirror * 0.2f, 0.65f, mirror * -0.25f, 0.65f);
}

void lock(Pen& pen, bool closed) {
    pen.box(-0.6f, -0.05f, 0.6f, 0.8f);
    pen.arc(0.0f, -0.35f, 0.36f, kPi, 2 * kPi);
    pen.line(-0.36f, -0.35f, -0.36f, -0.05f);
    if (closed) pen.line(0.36f, -0.35f, 0.36f, -0.05f);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float side, ImU32 color) {
    Pen pen(list, centre, side, color);
    switch (icon) {
        case Icon::Open:
            pen.path(std::array{ImVec2(-0.6f, 0.65f), ImVec2(-0.85f, 0.65f), ImVec2(-0.85f, -0.65f),
                                ImVec2(-0.3f, -0.65f), ImVec2(-0.1f, -0.4f), ImVec2(0.6f, -0.4f), ImVec2(0.6f, -0.1f)});
            pen.path(std::array{ImVec2(-0.85f, 0.65f), ImVec2(-0.5f, -0.1f), ImVec2(0.95f, -0.1f), ImVec2(0.6f, 0.65f)},
                     true);
            break;
        case Icon::Folder:
            pen.path(std::array{ImVec2(-0.85f, 0.65f), ImVec2(-0.85f, -0.65f), ImVec2(-0.25f, -0.65f),
                                ImVec2(0.0f, -0.4f), ImVec2(0.85f, -0.4f), ImVec2(0.85f, 0.65f)},
                     true);
            break;
        case Icon::File:
            pen.path(std::array{ImVec2(-0.6f, -0.85f), ImVec2(0.2f, -0.85f), ImVec2(0.6f, -0.4f), ImVec2(0.6f, 0.85f),
                                ImVec2(-0.6f, 0.85f)},
                     true);
            break;
        case Icon::Save:
            pen.path(std::array{ImVec2(-0.75f, -0.75f), ImVec2(0.45f, -0.75f), ImVec2(0.75f, -0.45f),
                                ImVec2(0.75f, 0.75f), ImVec2(-0.75f, 0.75f)},
                     true);
            pen.path(
                std::array{ImVec2(-0.35f, -0.75f), ImVec2(-0.35f, -0.3f), ImVec2(0.3f, -0.3f), ImVec2(0.3f, -0.75f)});
            pen.path(std::array{ImVec2(-0.4f, 0.75f), ImVec2(-0.4f, 0.15f), ImVec2(0.4f, 0.15f), ImVec2(0.4f, 0.75f)});
            break;
        case Icon::Undo: turn(pen, 1.0f); break;
        case Icon::Redo: turn(pen, -1.0f); break;
        case Icon::Help:
            pen.circle(0, 0, 0.88f);
            pen.arc(0, -0.22f, 0.3f, -kPi, kPi * 0.35f);
            pen.line(0.13f, 0.04f, 0, 0.26f);
            pen.dot(0, 0.52f, 0.09f);
            break;
        case Icon::Up: pen.path(std::array{ImVec2(-0.5f, 0.25f), ImVec2(0, -0.3f), ImVec2(0.5f, 0.25f)}); break;
        case Icon::Down: pen.path(std::array{ImVec2(-0.5f, -0.25f), ImVec2(0, 0.3f), ImVec2(0.5f, -0.25f)}); break;
        case Icon::Left: pen.path(std::array{ImVec2(0.25f, -0.5f), ImVec2(-0.3f, 0), ImVec2(0.25f, 0.5f)}); break;
        case Icon::Right: pen.path(std::array{ImVec2(-0.25f, -0.5f), ImVec2(0.3f, 0), ImVec2(-0.25f, 0.5f)}); break;
        case Icon::Close:
            pen.line(-0.5f, -0.5f, 0.5f, 0.5f);
            pen.line(0.5f, -0.5f, -0.5f, 0.5f);
            break;
        case Icon::Plus:
            pen.line(-0.6f, 0, 0.6f, 0);
            pen.line(0, -0.6f, 0, 0.6f);
            break;
        case Icon::LockOpen: lock(pen, false); break;
        case Icon::LockClosed: lock(pen, true); break;
        case Icon::Reset:
            pen.arc(0, 0.05f, 0.65f, -0.75f * kPi, 0.95f * kPi);
            pen.path(std::array{ImVec2(-0.52f, -0.95f), ImVec2(-0.5f, -0.42f), ImVec2(0.02f, -0.42f)});
            break;
        case Icon::Grip:
            for (const float y : {-0.5f, 0.0f, 0.5f}) {
                pen.dot(-0.25f, y, 0.12f);
                pen.dot(0.25f, y, 0.12f);
            }
            break;
        case Icon::Play:
            pen.path(std::array{ImVec2(-0.4f, -0.65f), ImVec2(0.65f, 0), ImVec2(-0.4f, 0.65f)}, true);
            break;
        case Icon::Pause:
            pen.line(-0.35f, -0.6f, -0.35f, 0.6f);
            pen.line(0.35f, -0.6f, 0.35f, 0.6f);
            break;
        case Icon::Previous:
            pen.path(std::array{ImVec2(0.45f, -0.55f), ImVec2(-0.2f, 0), ImVec2(0.45f, 0.55f)});
            pen.line(-0.5f, -0.55f, -0.5f, 0.55f);
            break;
        case Icon::Share:
            pen.circle(-0.55f, 0.0f, 0.24f);
            pen.circle(0.55f, -0.55f, 0.24f);
            pen.circle(0.55f, 0.55f, 0.24f);
            pen.line(-0.33f, -0.11f, 0.33f, -0.44f);
            pen.line(-0.33f, 0.11f, 0.33f, 0.44f);
            break;
        case Icon::More:
            for (const float x : {-0.6f, 0.0f, 0.6f}) pen.dot(x, 0.0f, 0.15f);
            break;
        case Icon::Next:
            pen.path(std::array{ImVec2(-0.45f, -0.55f), ImVec2(0.2f, 0), ImVec2(-0.45f, 0.55f)});
            pen.line(0.5f, -0.55f, 0.5f, 0.55f);
            break;
    }
}

void draw_arrow(ImDrawList& list, ArrowLook look, ImVec2 from, ImVec2 to, float thickness, ImU32 color) {
    const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    if (length <= 0.0f) return;
    const ImVec2 along(dx / length, dy / length), across(-along.y, along.x);
    const auto at = [&](float t, float s) {
        return ImVec2(from.x + along.x * t + across.x * s, from.y + along.y * t + across.y * s);
    };
    const float head = std::min(0.5f * length, 3.6f * thickness), neck = length - head, half = 1.7f * thickness;

    if (look == ArrowLook::Dashed) {
        const float dash = neck / 5.0f;
        for (int i = 0; i < 5; i += 2)
            list.AddLine(at(static_cast<float>(i) * dash, 0), at(static_cast<float>(i + 1) * dash, 0), color,
                         thickness);
    } else if (look == ArrowLook::TwoHeads) {
        for (const float side : {-0.6f, 0.6f})
            list.AddLine(at(0, side * thickness), at(neck, side * thickness), color, 0.6f * thickness);
    } else {
        list.AddLine(at(0, 0), at(neck, 0), color, look == ArrowLook::Hollow ? 0.6f * thickness : thickness);
    }
    if (look == ArrowLook::Hollow)
        list.AddTriangle(at(neck, -half), at(neck, half), at(length, 0), color, 0.6f * thickness);
    else
        list.AddTriangleFilled(at(neck, -half), at(length, 0), at(neck, half), color);
    const float back = ArrowProportions::kToSecondHead * head;
    if (look == ArrowLook::TwoHeads)  // two heads, as in the picture
        list.AddTriangleFilled(at(neck - back, -half), at(length - back, 0), at(neck - back, half), color);
}

}  // namespace normalscope

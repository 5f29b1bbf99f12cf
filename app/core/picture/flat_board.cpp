#include "core/picture/flat_board.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace normalscope {

namespace {

constexpr double kLayer = 4e-4;  // of the way to the eye: more than the depth buffer needs to tell two apart

double turn(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }
glm::dvec2 left_of(glm::dvec2 way) { return {-way.y, way.x}; }

struct Head {
    static constexpr double kLength = 5.0, kHalf = 2.3;  ///< in widths of the shaft
    static constexpr double kLongest = 0.55;             ///< of the arrow
};

}  // namespace

FlatBoard::FlatBoard(Pane& pane, const FlatPlane& plane, double pixel_scale)
    : pane_(pane), plane_(plane), pixel_(pixel_scale * pane.view.world_per_pixel(plane.origin)) {}

void FlatBoard::polygon(std::span<const glm::dvec2> corners, const glm::vec3& color, int layer) {
    const glm::dvec3 eye = pane_.view.eye().xyz;
    // Moved toward the eye, a place stays where it is in the picture.
    const auto vertex = [&](glm::dvec2 place) {
        return SolidVertex{glm::vec3(glm::mix(plane_.at(place).xyz, eye, kLayer * layer)), glm::vec3(0.0f),
                           glm::vec4(color, 1.0f)};
    };
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const glm::dvec2 a = corners[0], b = corners[i - 1], c = corners[i];
        const bool front = turn(b - a, c - a) > 0.0;
        for (const glm::dvec2& corner : {a, front ? b : c, front ? c : b}) pane_.solids.push_back(vertex(corner));
    }
}

void FlatBoard::disc(glm::dvec2 centre, double radius, const glm::vec3& color, int layer) {
    constexpr int kSides = 24;
    std::array<glm::dvec2, kSides> corners;
    for (int i = 0; i < kSides; ++i) {
        const double angle = glm::two_pi<double>() * i / kSides;
        corners[static_cast<std::size_t>(i)] = centre + radius * pixel_ * glm::dvec2(std::cos(angle), std::sin(angle));
    }
    polygon(corners, color, layer);
}

void FlatBoard::line(std::span<const glm::dvec2> points, const Pen& pen) {
    if (pen.dash > 0.0)
        dashes(points, pen);
    else
        stroke(points, Ends::Open, pen);
}

void FlatBoard::loop(std::span<const glm::dvec2> points, const Pen& pen) {
    if (!(pen.dash > 0.0)) return stroke(points, Ends::Joined, pen);
    std::vector<glm::dvec2> round(points.begin(), points.end());
    if (!round.empty()) round.push_back(round.front());
    dashes(round, pen);
}

void FlatBoard::dashes(std::span<const glm::dvec2> points, const Pen& pen) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
    constexpr double kMost = 4000.0;
    // A whole number, lest the last meet the first in a loop.
    const double count = std::min(std::max(1.0, std::round(length / (2.0 * pen.dash * pixel_))), kMost),
                 each = 0.5 * length / count;
    std::vector<glm::dvec2> dash;
    double passed = 0.0;  // up to the corner at hand
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec2 a = points[i - 1], b = points[i];
        const double piece = glm::distance(a, b);
        double at = 0.0;
        while (at < piece) {
            const double part = std::fmod((passed + at) / each, 2.0);
            const bool on = part < 1.0;
            const double next = std::min(piece, at + std::max((std::floor(part) + 1.0 - part) * each, 1e-9 * length));
            if (on && dash.empty()) dash.push_back(glm::mix(a, b, at / piece));
            if (on) dash.push_back(glm::mix(a, b, next / piece));
            if (next < piece && on) stroke(dash, Ends::Open, pen), dash.clear();
            at = next;
        }
        passed += piece;
    }
    stroke(dash, Ends::Open, pen);
}

void FlatBoard::stroke(std::span<const glm::dvec2> given, Ends ends, const Pen& pen) {
    const bool closed = ends == Ends::Joined;
    const double half = 0.5 * pen.width * pixel_;
    std::vector<glm::dvec2> points;
    for (const glm::dvec2& p : given)
        if (points.empty() || glm::distance(p, points.back()) > 1e-4 * half) points.push_back(p);
    if (closed && points.size() > 2 && glm::distance(points.front(), points.back()) <= 1e-4 * half) points.pop_back();
    if (points.size() < 2) return;
    const std::size_t count = points.size(), pieces = closed ? count : count - 1;
    const auto way = [&](std::size_t piece) {
        return glm::normalize(points[(piece + 1) % count] - points[piece % count]);
    };
    // Bends are mitred, so that a smooth curve has no seams; at a sharp corner both pieces end under a disc.
    constexpr double kSharp = 0.8;  // the cosine of what it turns by
    const auto across = [&](std::size_t corner, std::size_t piece) {
        const bool inner = closed || (corner > 0 && corner < count - 1);
        if (!inner) return half * left_of(way(piece));
        const glm::dvec2 before = way((corner + count - 1) % count), after = way(corner % count);
        const double cosine = glm::dot(before, after);
        if (cosine < kSharp) return half * left_of(way(piece));
        return half / (1.0 + cosine) * left_of(before + after);
    };
    for (std::size_t i = 0; i < pieces; ++i) {
        const glm::dvec2 a = points[i], b = points[(i + 1) % count];
        const glm::dvec2 from = across(i, i), to = across((i + 1) % count, i);
        polygon(std::array{a - from, b - to, b + to, a + from}, pen.color, pen.layer);
        const bool bends = closed || i > 0;
        if (bends && glm::dot(way((i + count - 1) % count), way(i)) < kSharp)
            disc(a, 0.5 * pen.width, pen.color, pen.layer);
    }
}

void FlatBoard::arrow(glm::dvec2 base, glm::dvec2 vector, const Pen& pen, ArrowLook look, const glm::vec3& paper) {
    const double length = glm::length(vector);
    if (!(length > 0.0)) return;
    const glm::dvec2 along = vector / length, side = left_of(along);
    const double width = pen.width * pixel_;
    const double head = std::min(Head::kLength * width, Head::kLongest * length),
                 half = Head::kHalf / Head::kLength * head;
    const double shaft = length - head;
    const int parts = look == ArrowLook::Dashed ? 3 : 1;
    for (int i = 0; i < parts; ++i) {
        // A hair into the head: no seam between them.
        const double each = shaft / (2 * parts - 1), from = 2 * i * each,
                     to = i + 1 == parts ? shaft + 0.05 * head : from + each;
        const glm::dvec2 a = base + from * along, b = base + to * along, w = 0.5 * width * side;
        polygon(std::array{a - w, b - w, b + w, a + w}, pen.color, pen.layer);
    }
    const auto tip = [&](double at, double size, const glm::vec3& color, int layer) {
        const glm::dvec2 end = base + at * along, neck = end - size * head * along;
        polygon(std::array{neck - size * half * side, end, neck + size * half * side}, color, layer);
    };
    tip(length, 1.0, pen.color, pen.layer);
    if (look == ArrowLook::TwoHeads) tip(length - 0.9 * head, 1.0, pen.color, pen.layer);
    if (look == ArrowLook::Hollow) tip(length - head / 3.0, 0.5, paper, pen.layer + 1);
}

}  // namespace normalscope

#include "core/frame/solids.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

// Around a cone or a ball, and around a line, which is a few pixels thick: on a processor, each triangle of a pixel or two
// costs as much as one of sixteen.
constexpr int kSides = 12, kLineSides = 8;

struct Basis {
    glm::dvec3 u, v;
};
Basis perpendicular(const glm::dvec3& unit) {
    const glm::dvec3 helper = std::abs(unit.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, unit));
    return {u, glm::cross(unit, u)};
}
glm::dvec3 around(const Basis& basis, int side, int sides = kSides) {
    const double a = glm::two_pi<double>() * (side % sides) / sides;
    return std::cos(a) * basis.u + std::sin(a) * basis.v;
}

struct Corner {
    glm::dvec3 position, normal;
};
void add_triangle(Solids& solids, const Corner& a, const Corner& b, const Corner& c, const glm::vec4& color) {
    for (const Corner& corner : {a, b, c})
        solids.push_back({glm::vec3(corner.position), glm::vec3(corner.normal), color});
}
void add_quad(Solids& solids, const Corner& a, const Corner& b, const Corner& c, const Corner& d,
              const glm::vec4& color) {
    add_triangle(solids, a, b, c, color);
    add_triangle(solids, a, c, d, color);
}

// A band around an axis from one ring to the next; `slant` tilts the normals of a cone's side toward its tip.
void add_band(Solids& solids, const glm::dvec3& from, double from_radius, const glm::dvec3& to, double to_radius,
              const glm::dvec3& axis, double slant, const glm::vec4& color) {
    const Basis basis = perpendicular(axis);
    const auto corner = [&](const glm::dvec3& centre, double radius, int side) {
        const glm::dvec3 out = around(basis, side);
        return Corner{centre + radius * out, glm::normalize(out + slant * axis)};
    };
    for (int i = 0; i < kSides; ++i) {
        const Corner far = corner(to, to_radius, i + 1);
        add_triangle(solids, corner(from, from_radius, i), corner(from, from_radius, i + 1), far, color);
        if (to_radius > 0.0) add_triangle(solids, corner(from, from_radius, i), far, corner(to, to_radius, i), color);
    }
}
void add_disc(Solids& solids, const glm::dvec3& centre, double radius, const glm::dvec3& normal,
              const glm::vec4& color) {
    const Basis basis = perpendicular(normal);
    for (int i = 0; i < kSides; ++i)
        add_triangle(solids, {centre, normal}, {centre + radius * around(basis, i), normal},
                     {centre + radius * around(basis, i + 1), normal}, color);
}

}  // namespace

void add_arrow(Solids& solids, const glm::dvec3& base, const glm::dvec3& vector, double radius,
               const glm::vec4& color) {
    add_arrow(solids, base, vector, radius, color, ArrowLook::Plain, {});
}

void add_arrow(Solids& solids, const glm::dvec3& base, const glm::dvec3& vector, double full_radius,
               const glm::vec4& color, ArrowLook look, const glm::vec3& paper) {
    const double length = glm::length(vector);
    if (!(length > 0.0)) return;
    const double radius = (look == ArrowLook::Dashed ? ArrowProportions::kDashedWidth : 1.0f) * full_radius;
    const glm::dvec3 axis = vector / length;
    const double head =
        std::min<double>(ArrowProportions::kHeadLength * radius, ArrowProportions::kLongestHead * length);
    const double head_radius = ArrowProportions::kHeadRadius * radius;
    const glm::dvec3 neck = base + (length - head) * axis;
    const int pieces = look == ArrowLook::Dashed ? ArrowProportions::kDashes : 1;
    for (int piece = 0; piece < pieces; ++piece) {
        const double each = (length - head) / (2 * pieces - 1);
        const glm::dvec3 from = base + 2.0 * piece * each * axis, to = piece + 1 == pieces ? neck : from + each * axis;
        add_disc(solids, from, radius, -axis, color);
        add_band(solids, from, radius, to, radius, axis, 0.0, color);
        if (piece + 1 < pieces) add_disc(solids, to, radius, axis, color);
    }
    const auto add_head = [&](double share, const glm::vec4& of) {
        add_disc(solids, neck, share * head_radius, -axis, of);
        add_band(solids, neck, share * head_radius, neck + share * head * axis, 0.0, axis, head_radius / head, of);
    };
    const std::size_t first = solids.size();
    add_head(1.0, color);
    if (look == ArrowLook::Hollow) {
        // Turned inside out, the head shows its far side only: a rim about a smaller one of paper.
        for (std::size_t i = first; i < solids.size(); i += 3) std::swap(solids[i], solids[i + 1]);
        add_head(ArrowProportions::kHollow, glm::vec4(paper, 1.0f));
    }
    if (look != ArrowLook::TwoHeads) return;
    const double second = length - ArrowProportions::kToSecondHead * ArrowProportions::kHeadLength * radius;
    add_arrow(solids, base, second * axis, radius, color);
}

void add_tube(Solids& solids, std::span<const glm::dvec3> points, double radius, const glm::vec4& color, bool closed) {
    std::vector<glm::dvec3> line;
    for (const glm::dvec3& p : points)
        if (line.empty() || glm::length(p - line.back()) >= 1e-7 * radius) line.push_back(p);
    if (closed && line.size() > 1) line.push_back(line.front());
    if (line.size() < 2) return;
    const std::size_t pieces = line.size() - 1;
    const auto along = [&](std::size_t piece) { return glm::normalize(line[piece + 1] - line[piece]); };

    // The pieces meet in the plane that halves the angle between them, and each takes its basis over from the last.
    Basis basis = perpendicular(along(0));
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        const glm::dvec3 axis = along(piece);
        const auto halfway = [&](std::size_t other) { return glm::normalize(axis + along(other)); };
        const glm::dvec3 first = piece > 0 ? halfway(piece - 1) : closed ? halfway(pieces - 1) : axis;
        const glm::dvec3 last = piece + 1 < pieces ? halfway(piece + 1) : closed ? halfway(0) : axis;
        const auto onto = [&](const glm::dvec3& out, const glm::dvec3& plane) {
            return out - glm::dot(out, plane) / glm::dot(axis, plane) * axis;
        };
        const auto corner = [&](std::size_t end, const glm::dvec3& plane, int side) {
            const glm::dvec3 out = around(basis, side, kLineSides);
            return Corner{line[end] + radius * onto(out, plane), out};
        };
        for (int i = 0; i < kLineSides; ++i)
            add_quad(solids, corner(piece, first, i), corner(piece, first, i + 1), corner(piece + 1, last, i + 1),
                     corner(piece + 1, last, i), color);
        if (piece + 1 == pieces) break;
        const glm::dvec3 next = along(piece + 1);
        for (glm::dvec3* side : {&basis.u, &basis.v}) {
            const glm::dvec3 met = onto(*side, last);
            *side = met - glm::dot(met, next) * next;
        }
    }
    if (!closed)
        for (const glm::dvec3& end : {line.front(), line.back()}) add_ball(solids, end, radius, color);
}

std::vector<glm::dvec3> circle(const glm::dvec3& centre, const glm::dvec3& axis, double radius, int points) {
    const Basis basis = perpendicular(axis);
    std::vector<glm::dvec3> result;
    for (int i = 0; i < points; ++i) result.push_back(centre + radius * around(basis, i, points));
    return result;
}

void add_cube(Solids& solids, const glm::dvec3& centre, const glm::dvec3& direction, double half,
              const glm::vec4& color) {
    const glm::dvec3 w = glm::normalize(direction);
    const Basis basis = perpendicular(w);
    const std::array axes{basis.u, basis.v, w};
    for (std::size_t k = 0; k < 3; ++k)
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec3 n = side * axes[k], u = half * side * axes[(k + 1) % 3], v = half * axes[(k + 2) % 3];
            const glm::dvec3 middle = centre + half * n;
            add_quad(solids, {middle - u - v, n}, {middle + u - v, n}, {middle + u + v, n}, {middle - u + v, n}, color);
        }
}

void add_ball(Solids& solids, const glm::dvec3& centre, double radius, const glm::vec4& color) {
    constexpr int kRings = 6;
    const glm::dvec3 axis(0.0, 1.0, 0.0);
    const Basis basis = perpendicular(axis);
    const auto corner = [&](int ring, int side) {
        const double a = glm::pi<double>() * ring / kRings;
        const glm::dvec3 n = std::sin(a) * around(basis, side) - std::cos(a) * axis;
        return Corner{centre + radius * n, n};
    };
    for (int ring = 0; ring < kRings; ++ring)
        for (int side = 0; side < kSides; ++side) {
            const Corner a = corner(ring, side), c = corner(ring + 1, side + 1);
            if (ring > 0) add_triangle(solids, a, corner(ring, side + 1), c, color);
            if (ring + 1 < kRings) add_triangle(solids, a, c, corner(ring + 1, side), color);
        }
}

void add_polygon(Solids& solids, std::span<const glm::dvec3> corners, const glm::vec4& color) {
    const glm::dvec3 unlit(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        add_triangle(solids, {corners[0], unlit}, {corners[i - 1], unlit}, {corners[i], unlit}, color);
}

void add_patch(Solids& solids, const glm::dvec3& centre, const glm::dvec3& half_u, const glm::dvec3& half_v,
               const glm::vec4& color) {
    const glm::dvec3 unlit(0.0);
    add_quad(solids, {centre - half_u - half_v, unlit}, {centre + half_u - half_v, unlit},
             {centre + half_u + half_v, unlit}, {centre - half_u + half_v, unlit}, color);
}

void keep_clear(Pane& pane, std::span<const glm::dvec3> path, double half_width) {
    for (std::size_t i = 1; i < path.size(); ++i) pane.strokes.push_back({path[i - 1], path[i], half_width});
}

}  // namespace normalscope

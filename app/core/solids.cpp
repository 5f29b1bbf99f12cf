#include "core/solids.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

constexpr int kSides = 14;

struct Basis {
    glm::dvec3 u, v;
};
Basis perpendicular(const glm::dvec3& unit) {
    const glm::dvec3 helper = std::abs(unit.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, unit));
    return {u, glm::cross(unit, u)};
}
glm::dvec3 around(const Basis& basis, int side) {
    const double a = glm::two_pi<double>() * (side % kSides) / kSides;
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
    for (int i = 0; i < kSides; ++i)
        add_quad(solids, corner(from, from_radius, i), corner(from, from_radius, i + 1), corner(to, to_radius, i + 1),
                 corner(to, to_radius, i), color);
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
    const double length = glm::length(vector);
    if (!(length > 0.0)) return;
    const glm::dvec3 axis = vector / length;
    const double head =
        std::min<double>(ArrowProportions::kHeadLength * radius, ArrowProportions::kLongestHead * length);
    const double head_radius = ArrowProportions::kHeadRadius * radius;
    const glm::dvec3 neck = base + (length - head) * axis;
    add_disc(solids, base, radius, -axis, color);
    add_band(solids, base, radius, neck, radius, axis, 0.0, color);
    add_disc(solids, neck, head_radius, -axis, color);
    add_band(solids, neck, head_radius, base + vector, 0.0, axis, head_radius / head, color);
}

void add_tube(Solids& solids, std::span<const glm::dvec3> points, double radius, const glm::vec4& color, bool closed) {
    const std::size_t count = points.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const glm::dvec3 &from = points[i], &to = points[(i + 1) % count];
        if (glm::length(to - from) < 1e-9) continue;
        add_band(solids, from, radius, to, radius, glm::normalize(to - from), 0.0, color);
    }
    // Balls at the corners close the gaps between the straight pieces.
    for (const glm::dvec3& p : points) add_ball(solids, p, radius, color);
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
        for (int side = 0; side < kSides; ++side)
            add_quad(solids, corner(ring, side), corner(ring, side + 1), corner(ring + 1, side + 1),
                     corner(ring + 1, side), color);
}

void add_patch(Solids& solids, const glm::dvec3& centre, const glm::dvec3& half_u, const glm::dvec3& half_v,
               const glm::vec4& color) {
    const glm::dvec3 unlit(0.0);
    add_quad(solids, {centre - half_u - half_v, unlit}, {centre + half_u - half_v, unlit},
             {centre + half_u + half_v, unlit}, {centre - half_u + half_v, unlit}, color);
}

}  // namespace normalscope

#include "core/base/error.h"
#include "core/mesh/polygons.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <numeric>

namespace normalscope {

namespace {

constexpr std::size_t kMostConcaveCorners = 2000;  // clipping ears takes quadratic time

// Newell's method: the sum of the edges' cross products, which no single collinear or reflex corner can spoil.
glm::dvec3 newell_normal(const std::vector<glm::dvec3>& ring) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += glm::cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    return sum;
}

// The ring in the coordinate plane that it faces most, counterclockwise.
std::vector<glm::dvec2> flattened(const std::vector<glm::dvec3>& ring) {
    const glm::dvec3 n = newell_normal(ring), size = glm::abs(n);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    std::vector<glm::dvec2> flat;
    flat.reserve(ring.size());
    for (const glm::dvec3& p : ring) flat.emplace_back(n[drop] < 0.0 ? -p[u] : p[u], p[v]);
    return flat;
}

// Twice the signed area: positive where a, b, c turn left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Meisters' ear clipping, "Polygons have ears", 1975.
class EarClipper {
public:
    explicit EarClipper(const std::vector<glm::dvec3>& ring)
        : at_(flattened(ring)), next_(at_.size()), previous_(at_.size()) {
        const std::size_t n = at_.size();
        for (std::size_t i = 0; i < n; ++i) next_[i] = (i + 1) % n, previous_[i] = (i + n - 1) % n;
    }
    bool strictly_convex() const {
        for (std::size_t i = 0; i < at_.size(); ++i)
            if (!(turn(at_[previous_[i]], at_[i], at_[next_[i]]) > 0.0)) return false;
        return true;
    }
    void clip(std::vector<glm::uvec3>& triangles) {
        std::size_t left = at_.size(), corner = 0, since_last_ear = 0;
        while (left > 3) {
            // Where a whole round shows no ear, the polygon crosses itself or is flat: any cut is as good as another.
            if (is_ear(corner) || since_last_ear > left) {
                triangles.push_back(triangle(corner));
                next_[previous_[corner]] = next_[corner];
                previous_[next_[corner]] = previous_[corner];
                --left;
                since_last_ear = 0;
            }
            ++since_last_ear;
            corner = next_[corner];
        }
        triangles.push_back(triangle(corner));
    }

private:
    glm::uvec3 triangle(std::size_t corner) const {
        return {static_cast<std::uint32_t>(previous_[corner]), static_cast<std::uint32_t>(corner),
                static_cast<std::uint32_t>(next_[corner])};
    }
    bool is_ear(std::size_t corner) const {
        const glm::dvec2 &a = at_[previous_[corner]], &b = at_[corner], &c = at_[next_[corner]];
        if (!(turn(a, b, c) > 0.0)) return false;
        for (std::size_t i = next_[next_[corner]]; i != previous_[corner]; i = next_[i]) {
            const glm::dvec2& p = at_[i];
            if (p == a || p == b || p == c) continue;  // a hole's bridge passes such a corner twice
            if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
        }
        return true;
    }

    std::vector<glm::dvec2> at_;
    std::vector<std::size_t> next_, previous_;
};

// Quads are by far the commonest polygons: cut from the reflex corner where there is one.
bool cut_from_second_corner(const std::vector<glm::dvec3>& q) {
    const glm::dvec3 normal = glm::cross(q[2] - q[0], q[3] - q[1]);
    return glm::dot(glm::cross(q[1] - q[0], q[2] - q[0]), normal) <= 0.0 ||
           glm::dot(glm::cross(q[2] - q[0], q[3] - q[0]), normal) <= 0.0;
}

}  // namespace

void triangulate(const std::vector<glm::dvec3>& ring, std::vector<glm::uvec3>& triangles) {
    const auto n = static_cast<std::uint32_t>(ring.size());
    const auto fan = [&] {
        for (std::uint32_t i = 2; i < n; ++i) triangles.emplace_back(0, i - 1, i);
    };
    if (n < 4) return fan();
    if (n == 4) {
        if (!cut_from_second_corner(ring)) return fan();
        triangles.emplace_back(1, 2, 3);
        triangles.emplace_back(1, 3, 0);
        return;
    }
    EarClipper clipper(ring);
    if (clipper.strictly_convex()) return fan();
    if (n > kMostConcaveCorners)
        throw InputError("a concave face has " + std::to_string(n) + " corners, more than " +
                         std::to_string(kMostConcaveCorners) + "; triangulate it first");
    clipper.clip(triangles);
}

}  // namespace normalscope

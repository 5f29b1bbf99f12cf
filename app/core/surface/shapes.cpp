#include "core/surface/shapes.h"

#include "core/base/error.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <tuple>

namespace normalscope {

namespace {

constexpr double kTwoPi = glm::two_pi<double>();

/// A point with its exact normal.
struct Vertex {
    glm::dvec3 position, normal;
};

class Builder {
public:
    std::uint32_t vertex(const Vertex& v) {
        mesh_.positions.push_back(v.position);
        mesh_.normals.push_back(v.normal);
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }
    /// A convex polygon, counterclockwise seen from outside; corners that coincide (at a pole) give no triangle.
    void face(const std::vector<std::uint32_t>& corners) {
        bool any = false;
        for (std::size_t i = 2; i < corners.size(); ++i) {
            const glm::uvec3 t(corners[0], corners[i - 1], corners[i]);
            const auto at = [&](std::uint32_t k) { return mesh_.positions[k]; };
            if (at(t.x) == at(t.y) || at(t.y) == at(t.z) || at(t.z) == at(t.x)) continue;
            mesh_.triangles.push_back(t);
            mesh_.face_of_triangle.push_back(faces_);
            any = true;
        }
        faces_ += any ? 1 : 0;
    }
    /// A grid of (columns + 1) × (rows + 1) vertices over (u, v) in [0, 1]²; `wrap_u`, `wrap_v` join its ends.
    void grid(int columns, int rows, bool wrap_u, bool wrap_v, const std::function<Vertex(double, double)>& at) {
        const int wide = columns + (wrap_u ? 0 : 1), high = rows + (wrap_v ? 0 : 1);
        std::vector<std::uint32_t> index(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high));
        const auto slot = [&](int i, int j) -> std::uint32_t& {
            const int k = (j % high) * wide + i % wide;
            return index[static_cast<std::size_t>(k)];
        };
        for (int j = 0; j < high; ++j)
            for (int i = 0; i < wide; ++i) slot(i, j) = vertex(at(double(i) / columns, double(j) / rows));
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) face({slot(i, j), slot(i + 1, j), slot(i + 1, j + 1), slot(i, j + 1)});
    }

    Mesh take() { return std::move(mesh_); }

private:
    Mesh mesh_;
    std::uint32_t faces_ = 0;
};

struct LatticeVertex {
    int coarseness;  // how many times coarser a lattice it would still be part of
    glm::dvec3 p;
};

// On the unit sphere. The first vertices are the coarsest lattice's, so that every n-th arrow is evenly spread, too.
Mesh from_coarse_to_fine(const std::vector<LatticeVertex>& vertices, const std::vector<glm::uvec3>& triangles) {
    std::vector<std::uint32_t> order(vertices.size()), place(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, [&](auto a, auto b) { return vertices[a].coarseness > vertices[b].coarseness; });
    Mesh mesh;
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[order[i]] = static_cast<std::uint32_t>(i);
        mesh.positions.push_back(vertices[order[i]].p);
        mesh.normals.push_back(vertices[order[i]].p);
    }
    for (const glm::uvec3& t : triangles) mesh.triangles.push_back({place[t.x], place[t.y], place[t.z]});
    return mesh;
}

// A geodesic sphere: each face of the icosahedron in frequency² triangles, so that arrows on it are evenly spread.
Mesh sphere(int resolution) {
    const double g = glm::golden_ratio<double>();
    const std::array<glm::dvec3, 12> corners{{{-1, g, 0},
                                              {1, g, 0},
                                              {-1, -g, 0},
                                              {1, -g, 0},
                                              {0, -1, g},
                                              {0, 1, g},
                                              {0, -1, -g},
                                              {0, 1, -g},
                                              {g, 0, -1},
                                              {g, 0, 1},
                                              {-g, 0, -1},
                                              {-g, 0, 1}}};
    constexpr std::array<glm::ivec3, 20> kFaces{{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                 {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                 {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                 {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
    const int f = std::max(1, (resolution + 2) / 4);
    std::vector<LatticeVertex> vertices;
    std::vector<glm::uvec3> triangles;
    // Vertices on the icosahedron's edges belong to several faces: find them again by their rounded place.
    struct Less {
        bool operator()(const glm::i64vec3& a, const glm::i64vec3& b) const {
            return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        }
    };
    std::map<glm::i64vec3, std::uint32_t, Less> known;
    const auto vertex = [&](const glm::ivec3& face, int i, int j) {
        const auto corner = [&](int k) { return corners[static_cast<std::size_t>(face[k])]; };
        const glm::dvec3 p =
            glm::normalize(double(f - i - j) * corner(0) + double(i) * corner(1) + double(j) * corner(2));
        const auto [it, added] =
            known.try_emplace(glm::i64vec3(glm::round(1e9 * p)), static_cast<std::uint32_t>(vertices.size()));
        if (added) vertices.push_back({std::gcd(std::gcd(i, j), f), p});
        return it->second;
    };
    for (const glm::ivec3& face : kFaces) {
        std::vector<std::uint32_t> below, row;  // the lattice's rows j and j + 1
        for (int i = 0; i <= f; ++i) below.push_back(vertex(face, i, 0));
        for (int j = 0; j < f; ++j) {
            row.clear();
            for (int i = 0; i < f - j; ++i) row.push_back(vertex(face, i, j + 1));
            for (std::size_t i = 0; i < row.size(); ++i) {
                triangles.push_back({below[i], below[i + 1], row[i]});
                if (i + 1 < row.size()) triangles.push_back({below[i + 1], row[i + 1], row[i]});
            }
            std::swap(below, row);
        }
    }
    return from_coarse_to_fine(vertices, triangles);
}

// A flat convex polygon as one face with its own vertices, so that its corners keep the face's normal.
void flat_face(Builder& builder, const std::vector<glm::dvec3>& corners) {
    const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    std::vector<std::uint32_t> indices;
    for (const glm::dvec3& p : corners) indices.push_back(builder.vertex({p, normal}));
    builder.face(indices);
}

Mesh cube(int resolution) {
    Builder builder;
    const int n = std::max(1, resolution / 8);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 normal(0.0), u(0.0), v(0.0);
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1.0;
            builder.grid(n, n, false, false, [&](double s, double t) {
                return Vertex{normal + (2.0 * s - 1.0) * u + (2.0 * t - 1.0) * v, normal};
            });
        }
    return builder.take();
}

void disc(Builder& builder, int around, double y, double facing) {
    const int rings = std::max(1, around / 12);
    builder.grid(around, rings, true, false, [=](double u, double v) {
        const double a = facing * kTwoPi * u, r = 1.0 - v;
        return Vertex{{r * std::sin(a), y, r * std::cos(a)}, {0.0, facing, 0.0}};
    });
}

Mesh cylinder(int around) {
    Builder builder;
    builder.grid(around, std::max(1, around / 3), true, false, [](double u, double v) {
        const glm::dvec3 n(std::sin(kTwoPi * u), 0.0, std::cos(kTwoPi * u));
        return Vertex{n + glm::dvec3(0.0, 2.0 * v - 1.0, 0.0), n};
    });
    disc(builder, around, 1.0, 1.0);
    disc(builder, around, -1.0, -1.0);
    return builder.take();
}

// Apex at (0, 1, 0), base of radius 1 at y = −1. At the apex there is no normal; each side triangle keeps its own there.
Mesh cone(int around) {
    Builder builder;
    builder.grid(around, std::max(2, around / 3), true, false, [](double u, double v) {
        const double a = kTwoPi * u;
        const glm::dvec3 outward(std::sin(a), 0.0, std::cos(a));
        return Vertex{(1.0 - v) * outward + glm::dvec3(0.0, 2.0 * v - 1.0, 0.0),
                      glm::normalize(2.0 * outward + glm::dvec3(0.0, 1.0, 0.0))};
    });
    disc(builder, around, -1.0, -1.0);
    return builder.take();
}

Mesh torus(int around) {
    constexpr double kMajor = 0.7, kMinor = 0.3;
    Builder builder;
    builder.grid(around, std::max(3, around / 2), true, true, [](double u, double v) {
        const double a = kTwoPi * u, b = kTwoPi * v;
        const glm::dvec3 outward(std::sin(a), 0.0, std::cos(a));
        const glm::dvec3 n = std::cos(b) * outward + glm::dvec3(0.0, std::sin(b), 0.0);
        return Vertex{kMajor * outward + kMinor * n, n};
    });
    return builder.take();
}

Mesh plane(int resolution) {
    Builder builder;
    const int n = std::max(1, resolution / 8);
    builder.grid(n, n, false, false,
                 [](double u, double v) { return Vertex{{2.0 * u - 1.0, 0.0, 1.0 - 2.0 * v}, {0.0, 1.0, 0.0}}; });
    return builder.take();
}

// Regular, in the unit sphere. Its faces are the planes of the icosahedron's corners.
Mesh dodecahedron() {
    const double g = glm::golden_ratio<double>();
    std::vector<glm::dvec3> corners;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0}) corners.push_back({x, y, z});
            corners.push_back({0.0, x / g, y * g});
            corners.push_back({x / g, y * g, 0.0});
            corners.push_back({x * g, 0.0, y / g});
        }
    Builder builder;
    for (const double s : {-1.0, 1.0})
        for (const double t : {-1.0, 1.0})
            for (const glm::dvec3& n :
                 {glm::dvec3(0.0, s * g, t), glm::dvec3(s * g, t, 0.0), glm::dvec3(t, 0.0, s * g)}) {
                std::vector<glm::dvec3> face = corners;
                std::ranges::sort(face, std::greater{}, [&](const glm::dvec3& p) { return glm::dot(p, n); });
                face.resize(5);
                const glm::dvec3 centre = (face[0] + face[1] + face[2] + face[3] + face[4]) / 5.0;
                const glm::dvec3 u = glm::normalize(face[0] - centre), v = glm::cross(glm::normalize(n), u);
                std::ranges::sort(face, {}, [&](const glm::dvec3& p) {
                    return std::atan2(glm::dot(p - centre, v), glm::dot(p - centre, u));
                });
                for (glm::dvec3& p : face) p /= std::sqrt(3.0);
                flat_face(builder, face);
            }
    return builder.take();
}

}  // namespace

Mesh make_shape(const ShapeSurface& shape) {
    const int n = shape.resolution;
    if (n < 3 || n > 512)
        throw InputError("surface.resolution: " + std::to_string(n) + " is out of range; it must be from 3 to 512");
    const auto of_kind = [&] {
        switch (shape.shape) {
            case Shape::Sphere: return sphere(n);
            case Shape::Cube: return cube(n);
            case Shape::Cylinder: return cylinder(n);
            case Shape::Cone: return cone(n);
            case Shape::Torus: return torus(n);
            case Shape::Plane: return plane(n);
            case Shape::Dodecahedron: return dodecahedron();
        }
        return Mesh{};
    };
    Mesh mesh = of_kind();
    mesh.closed = shape.shape != Shape::Plane;
    return mesh;
}

}  // namespace normalscope

#include "core/surface/triangle_tree.h"

#include "random.h"

#include "core/surface/box_image.h"
#include "core/surface/mesh_probe.h"
#include "core/surface/shapes.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>

namespace normalscope {
namespace {

void expect_same(const std::optional<Probe>& a, const std::optional<Probe>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_EQ(a->point.xyz, b->point.xyz);
    EXPECT_EQ(a->normal.xyz, b->normal.xyz);
}

// Triangles that overlap, cross and repeat each other, some of them lines or points: whatever a file may hold.
Mesh soup(Random& random, int count, double size) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const glm::dvec3 at = random.vector(size);
        const double own = size * std::exp(random.uniform(-6.0, 0.0));
        for (int k = 0; k < 3; ++k) mesh.positions.push_back(at + own * random.vector());
        if (random.chance(0.1)) mesh.positions.back() = at;
        if (random.chance(0.05)) mesh.positions[first + 1] = mesh.positions[first];
        mesh.triangles.push_back({first, first + 1, first + 2});
        if (random.chance(0.2)) mesh.triangles.push_back({first + 1, first + 2, first});  // again: a tie
        mesh.normals.resize(mesh.positions.size(), random.direction());
    }
    return mesh;
}

Mesh any_mesh(Random& random) {
    const Shape shape = std::array{Shape::Sphere,   Shape::Cube,  Shape::Torus,       Shape::Cone,
                                   Shape::Cylinder, Shape::Plane, Shape::Dodecahedron}[std::size_t(random.below(7))];
    return random.chance(0.5) ? make_shape({shape, 3 + random.below(40)})
                              : soup(random, 1 + random.below(300), std::exp(random.uniform(-8.0, 8.0)));
}

Transform<World, Object> any_transform(Random& random) {
    Scene scene;
    scene.stack = random.stack(4);
    if (!random.chance(0.3)) return world_from_object(scene);
    glm::dmat4 m = world_from_object(scene).matrix();
    for (int i = 0; i < 3; ++i) m[i].w = random.uniform(-0.5, 0.5);  // some of the mesh may go beyond infinity
    return Transform<World, Object>(m);
}

// A corner, the middle of an edge, or somewhere beside the mesh.
Point<Object> any_place(const Mesh& mesh, Random& random) {
    const glm::uvec3& t = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    const glm::dvec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y];
    switch (random.below(4)) {
        case 0: return {a};
        case 1: return {0.5 * (a + b)};
        case 2: return {a + glm::length(b) * random.vector(0.5)};
        default: return {random.vector(3.0)};
    }
}

TEST(TriangleTree, FindsWhatLookingAtAllFinds) {
    Random random(41);
    int hits = 0, misses = 0;
    for (int i = 0; i < 400; ++i) {
        const Mesh mesh = any_mesh(random);
        const TriangleTree tree(mesh);
        const Transform<World, Object> m = any_transform(random);
        for (int k = 0; k < 20; ++k) {
            const Point<Object> from = any_place(mesh, random), toward = any_place(mesh, random);
            EXPECT_EQ(nearest_triangle(mesh, from), nearest_triangle(mesh, from, &tree)) << i;
            Ray<World> ray{m(from), m(toward) - m(from)};
            if (random.chance(0.3)) ray.direction = {{}}, ray.direction.xyz[random.below(3)] = 1.0;
            if (random.chance(0.3)) ray.origin.xyz -= 10.0 * ray.direction.xyz;
            const auto hit = first_hit(mesh, m, ray), by_tree = first_hit(mesh, m, ray, &tree);
            ASSERT_EQ(hit.has_value(), by_tree.has_value()) << i << " " << k;
            ++(hit ? hits : misses);
            if (!hit) continue;
            EXPECT_EQ(hit->t, by_tree->t) << i << " " << k;
            expect_same(hit->probe, by_tree->probe);
        }
        for (int k = 0; k < 10; ++k) {
            const Camera camera{random.uniform(-180, 180), random.uniform(-90, 90), std::exp(random.uniform(-5.0, 3.0)),
                                m(any_place(mesh, random))};
            const CameraView view(camera, {400, 300});
            const glm::dvec2 pixel(random.uniform(-100, 500), random.uniform(-100, 400));
            expect_same(probe_in_view(mesh, m, view, pixel), probe_in_view(mesh, m, view, pixel, &tree));
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(misses, 1000);
}

TEST(TriangleTree, LooksAtFew) {
    const Transform<World, Object> m(glm::dmat4(glm::dmat3(0.5, 0, 0, 1, 2, 0, 0, 0, 1)));
    const Ray<World> ray{{{2, 3, 5}}, {{-2, -2.9, -5}}};
    for (const int resolution : {64, 512}) {
        const TriangleTree tree(make_shape({Shape::Sphere, resolution}));
        const BoxImage image(m);
        int looked = 0;
        tree.search([&](const formulas::Box& box) { return image.entry(box, ray); },
                    [&](std::size_t) { return ++looked, std::numeric_limits<double>::infinity(); });
        EXPECT_GT(looked, 1) << resolution;
        EXPECT_LT(looked, 500) << resolution;  // both of its sides, which a hit would have spared
    }
}

TEST(TriangleTree, OfNothing) {
    const TriangleTree tree(Mesh{});
    EXPECT_FALSE(nearest_triangle(Mesh{}, {}, &tree));
    EXPECT_FALSE(first_hit(Mesh{}, {}, {{}, {{0, 0, 1}}}, &tree));
    EXPECT_FALSE(probe_in_view(Mesh{}, {}, CameraView({}, {400, 300}), {200, 150}, &tree));
}

TEST(TreeInTime, IsMadeForMany) {
    const Mesh few = make_shape({Shape::Cube, 16}), sphere = make_shape({Shape::Sphere, 64});
    const Mesh many = make_shape({Shape::Sphere, 256});
    TreeInTime of_few, of_sphere, of_many, asked_for;
    EXPECT_EQ(of_sphere.for_one(sphere), nullptr);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(of_few.for_one(few), nullptr);
    for (int i = 0; i < 100; ++i) of_sphere.for_one(sphere);
    EXPECT_NE(of_sphere.for_one(sphere), nullptr);
    for (int i = 0; i < 100; ++i) of_many.for_one(many);  // in the background
    EXPECT_NE(of_many.for_many(many), nullptr);
    EXPECT_NE(asked_for.for_many(few), nullptr);
    TreeInTime let_go;
    for (int i = 0; i < 100; ++i) let_go.for_one(many);
}

}  // namespace
}  // namespace normalscope

#include "core/surface/mesh_probe.h"

#include "random.h"

#include "core/surface/shapes.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {
namespace {

// Where a line enters the cube [−1, 1]³, by slabs.
std::optional<double> enters_cube(const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 a = (-1.0 - origin) / direction, b = (1.0 - origin) / direction;
    const glm::dvec3 low = glm::min(a, b), high = glm::max(a, b);
    const double enter = std::max({low.x, low.y, low.z}), leave = std::min({high.x, high.y, high.z});
    if (!(enter <= leave) || leave <= 0.0) return std::nullopt;
    return enter > 0.0 ? enter : leave;
}

void expect_orthonormal(const Probe& probe) {
    const glm::dvec3 n = probe.normal.xyz, t0 = probe.tangents[0].xyz, t1 = probe.tangents[1].xyz;
    EXPECT_LT(glm::length(glm::cross(t0, t1) - n), 1e-12);
    for (const glm::dvec3& v : {n, t0, t1}) EXPECT_NEAR(glm::length(v), 1.0, 1e-12);
}

TEST(Probe, FirstHitAgreesWithSlabs) {
    const Mesh cube = make_shape({Shape::Cube, 32});
    Random random(31);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        Scene scene;
        scene.stack = random.stack(4);
        const Transform<World, Object> m = world_from_object(scene);
        const auto object_from_world = m.inverse();
        if (!object_from_world || *m.normal_matrices_by_rule().condition() > 1e4) continue;
        const Point<Object> from{random.vector(4.0)}, toward{random.vector(1.5)};
        const Ray<World> ray{m(from), m(toward - from)};
        const auto expected = enters_cube(from.xyz, (toward - from).xyz);
        const auto hit = first_hit(cube, m, ray);
        ASSERT_EQ(hit.has_value(), expected.has_value()) << i;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(hit->t, *expected, 1e-7);
        EXPECT_LT(glm::length((from + hit->t * (toward - from)).xyz - hit->probe.point.xyz), 1e-6);
        expect_orthonormal(hit->probe);
    }
    EXPECT_GT(hits, 1000);
}

// Looking straight at edges, corners and seams, the ray must not slip through to the far side.
TEST(Probe, MiddleOfThePictureIsTheNearSide) {
    for (const Shape shape : {Shape::Sphere, Shape::Cube, Shape::Cylinder, Shape::Dodecahedron})
        for (int azimuth = -180; azimuth <= 180; azimuth += 15)
            for (int elevation = -90; elevation <= 90; elevation += 15) {
                Camera camera;
                camera.azimuth = azimuth;
                camera.elevation = elevation;
                const CameraView view(camera, {640, 480});
                const auto hit = first_hit(make_shape({shape, 16}), {}, view.ray({320, 240}));
                ASSERT_TRUE(hit);
                EXPECT_LT(hit->t, glm::length(view.eye().xyz) - 0.5) << azimuth << " " << elevation;
            }
}

TEST(Probe, NearestIsNearest) {
    const Mesh mesh = make_shape({Shape::Torus, 24});
    Random random(32);
    for (int i = 0; i < 300; ++i) {
        const Point<Object> p{random.vector(1.5)};
        const auto probe = nearest_probe(mesh, p);
        ASSERT_TRUE(probe);
        expect_orthonormal(*probe);
        const double distance = glm::length(probe->point.xyz - p.xyz);
        for (const glm::uvec3& t : mesh.triangles) {
            glm::dvec3 b(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
            b /= b.x + b.y + b.z;
            const glm::dvec3 q = b.x * mesh.positions[t.x] + b.y * mesh.positions[t.y] + b.z * mesh.positions[t.z];
            ASSERT_GE(glm::length(q - p.xyz), distance - 1e-12);
        }
    }
    EXPECT_FALSE(nearest_probe(Mesh{}, {}));
}

TEST(Probe, AMissGivesTheSilhouette) {
    const Mesh mesh = make_shape({Shape::Sphere, 32});
    Random random(33);
    for (int i = 0; i < 200; ++i) {
        Scene scene;
        scene.stack = random.stack(3);
        scene.camera = {random.uniform(-180, 180), random.uniform(-80, 80), 0.05, {random.vector(2.0)}};
        const Transform<World, Object> m = world_from_object(scene);
        const CameraView view(scene.camera, {400, 300});
        const glm::dvec2 pixel(random.uniform(0, 400), random.uniform(0, 300));
        if (first_hit(mesh, m, view.ray(pixel))) continue;
        const auto probe = probe_in_view(mesh, m, view, pixel);
        if (!probe) continue;  // wholly behind the eye
        const glm::dvec3 at = view.pixel(m(probe->point));
        EXPECT_GT(at.z, 0.0);
        const double distance = glm::length(glm::dvec2(at) - pixel);
        for (const glm::dvec3& p : mesh.positions) {
            const glm::dvec3 other = view.pixel(m(Point<Object>{p}));
            if (other.z > 0.0) {
                ASSERT_GE(glm::length(glm::dvec2(other) - pixel), distance - 1e-6);
            }
        }
    }
    EXPECT_FALSE(probe_in_view(Mesh{}, {}, CameraView({}, {400, 300}), {200, 150}));
}

TEST(Probe, NumbersInWorld) {
    const Mesh mesh = make_shape({Shape::Sphere, 64});
    const auto probe = nearest_probe(mesh, {{1, 1, 0}});
    const ProbeInWorld p = in_world(*probe, Transform<World, Object>(matrix(Scale{{0.5, 2, 1}})));
    EXPECT_NEAR(*p.error_degrees, 61.928, 0.1);
    EXPECT_NEAR((*p.dots[1])[0], 0.0, 1e-14);
    EXPECT_NEAR((*p.dots[1])[1], 0.0, 1e-14);
    EXPECT_GT(std::abs((*p.dots[0])[0]) + std::abs((*p.dots[0])[1]), 0.1);
    const ProbeInWorld flat = in_world(*probe, Transform<World, Object>(matrix(Scale{{1, 0, 1}})));
    EXPECT_FALSE(flat.normals[1]);
    EXPECT_FALSE(flat.dots[1]);
    EXPECT_FALSE(flat.error_degrees);
    EXPECT_TRUE(flat.normals[2]);
}

TEST(Camera, RayAndPixelAreInverse) {
    Random random(34);
    for (int i = 0; i < 2000; ++i) {
        const Camera camera{
            random.uniform(-400, 400), random.uniform(-90, 90), std::exp(random.uniform(-3, 3)), {random.vector(3.0)}};
        const glm::dvec2 size(random.uniform(50, 2000), random.uniform(50, 2000));
        const CameraView view(camera, size);
        const glm::dvec2 pixel(random.uniform(0, 1) * size.x, random.uniform(0, 1) * size.y);
        const Ray<World> ray = view.ray(pixel);
        const Point<World> p = ray.origin + random.uniform(1.0, 20.0) * ray.direction;
        const glm::dvec3 back = view.pixel(p);
        EXPECT_LT(glm::length(glm::dvec2(back) - pixel), 1e-7);
        EXPECT_GT(back.z, 0.0);
        // The GPU, which uses the matrix, sees the same.
        const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(p.xyz, 1.0);
        EXPECT_NEAR((clip.x / clip.w + 1.0) / 2.0 * size.x, pixel.x, 1e-6);
        EXPECT_NEAR((1.0 - clip.y / clip.w) / 2.0 * size.y, pixel.y, 1e-6);
        const Point<World> beside = p + view.world_per_pixel(p) * view.right();
        EXPECT_NEAR(glm::length(glm::dvec2(view.pixel(beside)) - pixel), 1.0, 1e-6);
    }
}

}  // namespace
}  // namespace normalscope

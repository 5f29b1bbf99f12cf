#include "core/surface/face_polygon.h"

#include "random.h"

#include "core/surface/surface_probe.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <memory>

namespace normalscope {
namespace {

std::shared_ptr<const Surface> surface_of(SurfaceSource source, ArrowPlacement at = ArrowPlacement::Vertices) {
    Scene scene;
    scene.surface = std::move(source);
    scene.arrows.at = at;
    return SurfaceCache().get(scene);
}

Probe polygon_near(const Surface& surface, const glm::dvec3& p) {
    return with_polygon(*nearest_probe(surface, Point<Object>{p}), surface);
}

// H lies in the tangent plane, its edges are the tangents, and it goes around the normal.
void expect_sound(const Probe& probe) {
    const std::vector<Point<Object>>& h = probe.polygon;
    ASSERT_GE(h.size(), 3u);
    for (std::size_t k = 0; k < h.size(); ++k) {
        const Vector<Object> edge = h[(k + 1) % h.size()] - h[k], next = h[(k + 2) % h.size()] - h[(k + 1) % h.size()];
        EXPECT_NEAR(glm::dot(edge.xyz, probe.normal.xyz), 0.0, 1e-9);
        EXPECT_GT(glm::dot(glm::cross(edge.xyz, next.xyz), probe.normal.xyz), 0.0);
        if (k < 2) {
            EXPECT_LT(glm::length(edge.xyz - probe.tangents.at(k).xyz), 1e-12);
        }
    }
    EXPECT_NEAR(glm::dot(h[0].xyz - probe.point.xyz, probe.normal.xyz), 0.0, 1e-6);
}

TEST(FacePolygon, IsTheFaceThatAFlatSurfaceHasThere) {
    for (const ArrowPlacement at : {ArrowPlacement::Vertices, ArrowPlacement::Faces})
        for (const int resolution : {3, 64}) {
            const Probe side = polygon_near(*surface_of(ShapeSurface{Shape::Cube, resolution}, at), {0.3, 1.0, -0.4});
            expect_sound(side);
            EXPECT_EQ(side.polygon.size(), 4u);
            EXPECT_LT(glm::length(side.normal.xyz - glm::dvec3(0, 1, 0)), 1e-12);
            for (const Point<Object>& corner : side.polygon)
                EXPECT_LT(glm::length(glm::abs(corner.xyz) - glm::dvec3(1.0)), 1e-12);
        }
    const Probe pentagon = polygon_near(*surface_of(ShapeSurface{Shape::Dodecahedron, 64}), {0.1, 0.9, 0.2});
    expect_sound(pentagon);
    EXPECT_EQ(pentagon.polygon.size(), 5u);
    EXPECT_EQ(polygon_near(*surface_of(ShapeSurface{Shape::Plane, 64}), {0.2, 0.0, 0.1}).polygon.size(), 4u);
}

TEST(FacePolygon, IsAPentagonWhereTheSurfaceIsCurvedOrItsFaceHasManyCorners) {
    for (const SurfaceSource& source : {SurfaceSource(ShapeSurface{Shape::Sphere, 64}), SurfaceSource(FormulaSurface{}),
                                        SurfaceSource(ShapeSurface{Shape::Torus, 64})}) {
        const auto surface = surface_of(source);
        const Probe before = *nearest_probe(*surface, Point<Object>{{0.7, 0.4, 0.5}});
        const Probe probe = with_polygon(before, *surface);
        expect_sound(probe);
        EXPECT_EQ(probe.polygon.size(), 5u);
        EXPECT_EQ(probe.normal.xyz, before.normal.xyz);
        EXPECT_EQ(probe.point, before.point);
        EXPECT_NEAR(probe.tangents[0].xyz.y, 0.0, 1e-12);  // level
    }
    const Probe cap = polygon_near(*surface_of(ShapeSurface{Shape::Cylinder, 64}), {0.2, 1.0, 0.1});
    expect_sound(cap);
    EXPECT_EQ(cap.polygon.size(), 5u);
    EXPECT_LT(glm::length(cap.normal.xyz - glm::dvec3(0, 1, 0)), 1e-12);
}

TEST(FacePolygon, KeepsTheRightNormalAcrossItsEdgesUnderAnyM) {
    const auto cube = surface_of(ShapeSurface{Shape::Cube, 8}), ball = surface_of(ShapeSurface{Shape::Sphere, 64});
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        Scene scene;
        scene.stack = random.stack(3);
        const Transform<World, Object> m = world_from_object(scene);
        if (m.rank() < 3 || *m.normal_matrices_by_rule().condition() > 1e3) continue;
        const Probe probe = polygon_near(i % 2 == 0 ? *cube : *ball, 2.0 * random.direction());
        const ProbeInWorld world = in_world(probe, m);
        ASSERT_EQ(world.polygon.size(), probe.polygon.size());
        const auto n = world.normals[Rule::InverseTranspose];
        ASSERT_TRUE(n);
        for (std::size_t k = 0; k < world.polygon.size(); ++k) {
            const glm::dvec3 edge = world.polygon[(k + 1) % world.polygon.size()].xyz - world.polygon[k].xyz;
            EXPECT_LT(std::abs(glm::dot(edge, n->xyz)), 1e-9 * glm::length(edge) * glm::length(n->xyz));
            if (k < 2) {
                EXPECT_LT(glm::length(edge - world.tangents.at(k).xyz), 1e-9 * (1.0 + glm::length(edge)));
            }
        }
    }
}

// As files have them: with rounded normals, and of a triangle beside a flat face that is itself part of a round one.
TEST(FacePolygon, TakesRoundedNormalsForFlatAndRoundedEdgesForRound) {
    Surface surface;
    surface.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
    surface.mesh.normals = {{0, 0, 1}, {0, 0.0005, 1}, {0, 0, 1}, {0.0003, 0, 1}, glm::normalize(glm::dvec3(1, 0, 1))};
    surface.mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
    surface.extent = {2, 1, 0};
    const Probe flat = polygon_near(surface, {0.5, 0.5, 0});
    expect_sound(flat);
    EXPECT_EQ(flat.polygon.size(), 4u);
    const Probe round = polygon_near(surface, {1.3, 0.2, 0});
    expect_sound(round);
    EXPECT_EQ(round.polygon.size(), 5u);
}

TEST(FacePolygon, NeedsANormal) {
    const auto cone = surface_of(FormulaSurface{.formula = "x^2+z^2=y^2"});
    const Probe apex = polygon_near(*cone, {0, 0, 0});
    EXPECT_FALSE(apex.has_normal());
    EXPECT_TRUE(apex.polygon.empty());
}

}  // namespace
}  // namespace normalscope

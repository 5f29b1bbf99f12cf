#include "core/mesh/mesh.h"

#include "core/surface/shapes.h"
#include "core/surface/surface.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {
namespace {

double smallest_gap(const std::vector<Site>& sites) {
    double gap = 1e300;
    for (std::size_t i = 0; i < sites.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) gap = std::min(gap, glm::length(sites[i].point.xyz - sites[k].point.xyz));
    return gap;
}

TEST(Thinned, SpreadsEvenly) {
    for (const Shape shape : {Shape::Sphere, Shape::Torus, Shape::Cone, Shape::Plane}) {
        const Mesh mesh = make_shape({shape, 256});
        const double area = surface_area(mesh);
        for (const std::size_t limit : {std::size_t{1}, std::size_t{10}, std::size_t{160}, std::size_t{500}}) {
            const std::vector<Site> all = face_sites(mesh), few = thinned(all, 1, limit, area);
            ASSERT_LE(few.size(), limit);
            EXPECT_GE(few.size(), limit / 2);
            if (few.size() < 2) continue;
            const double gap = smallest_gap(few);
            EXPECT_GT(gap, 0.8 * std::sqrt(area / static_cast<double>(limit)));
            // Nowhere is there room for one more.
            for (std::size_t i = 0; i < all.size(); i += 7)
                EXPECT_TRUE(std::ranges::any_of(
                    few, [&](const Site& s) { return glm::length(s.point.xyz - all[i].point.xyz) < 1.05 * gap; }));
        }
    }
}

TEST(Thinned, TakesEveryNth) {
    const std::vector<Site> all = vertex_sites(make_shape({Shape::Sphere, 8}));
    const std::vector<Site> third = thinned(all, 3, 1000, 4 * 3.14);
    ASSERT_EQ(third.size(), (all.size() + 2) / 3);
    for (std::size_t i = 0; i < third.size(); ++i) EXPECT_EQ(third[i].point, all[3 * i].point);
    EXPECT_EQ(thinned(all, 1, 0, 1.0).size(), 0u);
    EXPECT_EQ(thinned(all, 1000000, 10, 1.0).size(), 1u);
    EXPECT_EQ(thinned({}, 1, 10, 1.0).size(), 0u);
}

// An area that has nothing to do with the sites' extent, as of a sliver, must neither overflow nor take forever.
TEST(Thinned, SurvivesSlivers) {
    std::vector<Site> line;
    for (int i = 0; i < 5000; ++i) line.push_back({{{i / 5000.0, 0.0, 0.0}}, {{0.0, 1.0, 0.0}}});
    const std::vector<Site> few = thinned(line, 1, 100, 1e-30);
    EXPECT_LE(few.size(), 100u);
    EXPECT_GE(few.size(), 50u);
    EXPECT_LE(thinned(std::vector<Site>(1000, line[5]), 1, 10, 1.0).size(), 1u);
}

TEST(Mesh, FitsTheUnitSphere) {
    for (const double size : {1e-20, 1.0, 1e30}) {
        Mesh mesh = make_shape({Shape::Cone, 32});
        for (glm::dvec3& p : mesh.positions) p = size * (p + glm::dvec3(3, 4, 5));
        fit_to_unit_sphere(mesh);
        double farthest = 0.0;
        for (const glm::dvec3& p : mesh.positions) farthest = std::max(farthest, glm::length(p));
        EXPECT_NEAR(farthest, 1.0, 1e-14);
    }
    Mesh point;
    point.positions = {{7, 7, 7}};
    fit_to_unit_sphere(point);
    EXPECT_EQ(point.positions[0], glm::dvec3(0));
}

TEST(Mesh, AreaWeighsNormals) {
    // At the origin meet a large triangle that faces z and a small one that faces x.
    const std::vector<glm::dvec3> positions{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<glm::dvec3> normals = area_weighted_normals(positions, {{0, 1, 2}, {0, 3, 4}});
    EXPECT_LT(glm::length(normals[0] - glm::normalize(glm::dvec3(1, 0, 16))), 1e-15);
    EXPECT_EQ(normals[1], glm::dvec3(0, 0, 1));
}

TEST(Surface, FlatShadingGivesEachFaceItsNormal) {
    const Mesh flat = flat_shaded(make_shape({Shape::Dodecahedron, 3}));
    EXPECT_EQ(flat.positions.size(), 108u);
    EXPECT_EQ(flat.face_count(), 12u);
    for (std::size_t i = 0; i < flat.triangles.size(); ++i) {
        const glm::uvec3 t = flat.triangles[i];
        const glm::dvec3 n =
            glm::cross(flat.positions[t.y] - flat.positions[t.x], flat.positions[t.z] - flat.positions[t.x]);
        for (int k = 0; k < 3; ++k) EXPECT_LT(glm::length(glm::normalize(n) - flat.normals[t[k]]), 1e-14);
    }
}

TEST(Surface, CacheMakesAgainOnlyWhatChanged) {
    SurfaceCache cache;
    Scene scene;
    const auto first = cache.get(scene);
    scene.stack = {Scale{{1, 2, 3}}};
    scene.arrows.length = 0.5;
    EXPECT_EQ(cache.get(scene), first);
    scene.arrows.at = ArrowPlacement::Faces;
    const auto faces = cache.get(scene);
    EXPECT_NE(faces, first);
    EXPECT_EQ(faces->mesh.positions.size(), 3 * first->mesh.triangles.size());
    scene.arrows.at = ArrowPlacement::Vertices;
    scene.arrows.limit = 20;
    const auto again = cache.get(scene);
    EXPECT_EQ(again->mesh.positions, first->mesh.positions);
    EXPECT_LE(again->arrows.size(), 20u);
    scene.surface = MeshSurface{"there is no such.obj"};
    EXPECT_ANY_THROW(cache.get(scene));
    scene.surface = ShapeSurface{};
    EXPECT_EQ(cache.get(scene), again);
}

}  // namespace
}  // namespace normalscope

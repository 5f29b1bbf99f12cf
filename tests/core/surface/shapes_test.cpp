#include "core/surface/shapes.h"

#include "core/base/error.h"
#include "core/scene/scene_json.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <tuple>

namespace normalscope {
namespace {

constexpr double kPi = glm::pi<double>();

struct Expected {
    Shape shape;
    int euler;      // V − E + F of the welded surface; boundary edges allowed for the plane only
    double area;    // of the ideal surface
    double volume;  // 0: not closed
};
void PrintTo(const Expected& e, std::ostream* out) { *out << name(e.shape); }
const Expected kExpected[] = {{Shape::Sphere, 2, 4 * kPi, 4 * kPi / 3},
                              {Shape::Cube, 2, 24, 8},
                              {Shape::Cylinder, 2, 6 * kPi, 2 * kPi},
                              {Shape::Cone, 2, kPi * (1 + std::sqrt(5.0)), 2 * kPi / 3},
                              {Shape::Torus, 0, 4 * kPi* kPi * 0.7 * 0.3, 2 * kPi* kPi * 0.7 * 0.09},
                              {Shape::Plane, 1, 4, 0},
                              {Shape::Dodecahedron, 2, 10.51462224, 2.78516386}};

class Shapes : public testing::TestWithParam<std::tuple<Expected, int>> {};

TEST_P(Shapes, AreClosedOrientedAndExact) {
    const auto [expected, resolution] = GetParam();
    const Mesh mesh = make_shape({expected.shape, resolution});
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    ASSERT_EQ(mesh.normal_source, NormalSource::Exact);
    EXPECT_TRUE(mesh.notes.empty());
    for (const glm::dvec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1.0, 1e-14);
    for (const glm::dvec3& p : mesh.positions)
        EXPECT_LE(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1.0 + 1e-14);

    // Seams have vertices of their own on each side: weld by place.
    std::map<std::tuple<long, long, long>, std::uint32_t> known;
    std::vector<std::uint32_t> weld;
    for (const glm::dvec3& p : mesh.positions) {
        const glm::dvec3 r = glm::round(1e8 * p);
        weld.push_back(known.try_emplace({long(r.x), long(r.y), long(r.z)}, static_cast<std::uint32_t>(known.size()))
                           .first->second);
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;  // directed
    double area = 0.0, volume = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
        const glm::dvec3 twice_area = glm::cross(b - a, c - a);
        ASSERT_GT(glm::length(twice_area), 1e-12);
        area += 0.5 * glm::length(twice_area);
        volume += glm::dot(a, twice_area) / 6.0;
        for (int k = 0; k < 3; ++k) {
            EXPECT_GT(glm::dot(mesh.normals[t[k]], twice_area), 0.0) << "winding and normal disagree";
            ++edges[{weld[t[k]], weld[t[(k + 1) % 3]]}];
        }
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> undirected;
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);  // each edge is passed once in each direction
        if (expected.volume > 0.0) {
            EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
        }
        undirected.insert(std::minmax(edge.first, edge.second));
    }
    EXPECT_EQ(
        static_cast<int>(known.size()) - static_cast<int>(undirected.size()) + static_cast<int>(mesh.triangles.size()),
        expected.euler);

    // A polyhedron inscribed in the ideal surface is smaller, and approaches it quadratically.
    const double coarse = 40.0 / resolution / resolution;
    EXPECT_NEAR(area / expected.area, 1.0, coarse);
    EXPECT_NEAR(area, surface_area(mesh), 1e-9);
    if (expected.volume > 0.0) {
        EXPECT_NEAR(volume / expected.volume, 1.0, coarse);
    }

    // Faces ascend, and each has a site with a unit normal on the outside.
    EXPECT_TRUE(std::ranges::is_sorted(mesh.face_of_triangle));
    const std::vector<Site> sites = face_sites(mesh);
    EXPECT_EQ(sites.size(), mesh.face_count());
    for (const Site& site : sites) EXPECT_NEAR(glm::length(site.normal.xyz), 1.0, 1e-14);
}

std::string test_name(const testing::TestParamInfo<std::tuple<Expected, int>>& info) {
    const auto& [expected, resolution] = info.param;
    return std::string(name(expected.shape)) + "_" + std::to_string(resolution);
}
INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::Combine(testing::ValuesIn(kExpected), testing::Values(8, 13, 64, 100)),
                         test_name);

TEST(Shape, DodecahedronHasTwelvePentagons) {
    const Mesh mesh = make_shape({Shape::Dodecahedron, 3});
    EXPECT_EQ(mesh.face_count(), 12u);
    EXPECT_EQ(mesh.triangles.size(), 36u);
    for (const glm::dvec3& p : mesh.positions) EXPECT_NEAR(glm::length(p), 1.0, 1e-14);
}

TEST(Shape, ExtremeResolutions) {
    for (const Expected& e : kExpected) {
        EXPECT_GE(make_shape({e.shape, 3}).triangles.size(), 2u);
        EXPECT_GE(make_shape({e.shape, 512}).triangles.size(), 2u);
        EXPECT_THROW(make_shape({e.shape, 2}), InputError);
        EXPECT_THROW(make_shape({e.shape, 513}), InputError);
    }
}

}  // namespace
}  // namespace normalscope

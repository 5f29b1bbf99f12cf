#include "core/surface/kinks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace normalscope {
namespace {

Mesh cut(const std::string& text) {
    const ImplicitSurface surface(FormulaSurface{text, {}, 1.5});
    return cut_at_kinks(polygonised(surface, 24), surface);
}

double farthest_from_zero(const Mesh& mesh, double (*f)(const glm::dvec3&)) {
    double most = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(f(mesh.positions[t[k]])));
    return most;
}

// A cube gets its edges and corners, where the mesh before had them planed off.
TEST(Kinks, AreEdges) {
    const Mesh cube = cut("max(max(abs(x),abs(y)),abs(z))-0.8");
    EXPECT_LT(
        farthest_from_zero(
            cube, [](const glm::dvec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 0.8; }),
        1e-9);
    double area = 0.0;
    for (const glm::uvec3& t : cube.triangles) {
        const glm::dvec3 n =
            glm::cross(cube.positions[t.y] - cube.positions[t.x], cube.positions[t.z] - cube.positions[t.x]);
        area += 0.5 * glm::length(n);
        for (int k = 0; k < 3; ++k) EXPECT_GE(glm::dot(n, cube.normals[t[k]]), 0.999 * glm::length(n) - 1e-12);
    }
    EXPECT_NEAR(area, 6 * 1.6 * 1.6, 1e-9);
}

TEST(Kinks, AreNotWhereTheSurfaceOnlyBends) {
    for (const std::string text : {"x^2+y^2+z^2-0.02", "x^2+y^2-z^2", "x^2+y^2+z^2-1"}) {
        const ImplicitSurface surface(FormulaSurface{text, {}, 1.5});
        const Mesh mesh = polygonised(surface, 24);
        EXPECT_EQ(cut_at_kinks(mesh, surface).triangles, mesh.triangles) << text;
    }
}

}  // namespace
}  // namespace normalscope

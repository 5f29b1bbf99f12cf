#include "random.h"

#include "core/base/error.h"
#include "core/mesh/polygons.h"

#include <gtest/gtest.h>
#include <glm/trigonometric.hpp>

#include <algorithm>

namespace normalscope {
namespace {

// Star-shaped polygons, mostly concave, anywhere in space: the triangles cover them exactly.
TEST(Triangulate, CoversThePolygon) {
    Random random(41);
    for (int i = 0; i < 20'000 && !HasFailure(); ++i) {
        const int n = 3 + random.below(random.chance(0.1) ? 60 : 6);
        const glm::dmat3 plane = glm::dmat3(matrix(StackEntry{Rotate{random.direction(), random.uniform(0, 360)}}));
        std::vector<glm::dvec2> flat;
        std::vector<glm::dvec3> ring;
        for (int k = 0; k < n; ++k) {
            const double angle = 2.0 * std::acos(-1.0) * (k + random.uniform(0.0, n == 3 ? 0.4 : 0.9)) / n,
                         radius = random.uniform(0.05, 1.0);
            flat.push_back(radius * glm::dvec2(std::cos(angle), std::sin(angle)));
            ring.push_back(plane * glm::dvec3(flat.back(), 0.0) + glm::dvec3(3, 4, 5));
        }
        double area = 0.0, covered = 0.0;
        for (std::size_t k = 0; k < flat.size(); ++k) {
            const glm::dvec2 &a = flat[k], &b = flat[(k + 1) % flat.size()];
            area += 0.5 * (a.x * b.y - a.y * b.x);
        }
        std::vector<glm::uvec3> triangles;
        triangulate(ring, triangles);
        ASSERT_EQ(triangles.size(), static_cast<std::size_t>(n - 2));
        for (const glm::uvec3& t : triangles) {
            const double part = 0.5 * glm::dot(glm::cross(ring[t.y] - ring[t.x], ring[t.z] - ring[t.x]), plane[2]);
            EXPECT_GE(part, -1e-12);  // none turned over, so that equal area means no overlap
            covered += part;
        }
        EXPECT_NEAR(covered, area, 1e-10);
    }
}

// ---- Damaged files: a mesh or one line of error, whatever the bytes ---------------------------------------------

std::string damaged(std::string bytes, Random& random) {
    const auto some = [&] { return std::size_t{1} + static_cast<std::size_t>(random.below(20)); };
    for (int n = 1 + random.below(4); n > 0 && !bytes.empty(); --n) {
        const auto at = static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())));
        switch (random.below(4)) {
            case 0: bytes[at] = static_cast<char>(random.below(256)); break;
            case 1: bytes[at] = "0123456789-.e \n"[random.below(15)]; break;
            case 2: bytes.erase(at, some()); break;
            default: bytes.insert(at, bytes.substr(at, some()));
        }
    }
    return bytes;
}

void survives(std::uint64_t seed, const std::string& sound, Polygons (*read)(std::string_view, const std::string&)) {
    Random random(seed);
    int meshes = 0;
    for (int i = 0; i < 4000 && !testing::Test::HasFailure(); ++i) {
        const std::string bytes = damaged(sound, random);
        try {
            const Mesh mesh = mesh_of(read(bytes, "file"), "file");
            ++meshes;
            for (const glm::dvec3& p : mesh.positions) EXPECT_LE(glm::length(p), 1.0 + 1e-12);
            for (const glm::uvec3& t : mesh.triangles) EXPECT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
            EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
        } catch (const InputError& e) {
            EXPECT_TRUE(std::string(e.what()).starts_with("file: ")) << e.what();
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
        }
    }
    EXPECT_GT(meshes, 50);
}

const std::string kPlyHeader =
    " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement face 2\n"
    "property list uchar int vertex_indices\nproperty uchar flags\nend_header\n";

TEST(DamagedFile, Obj) {
    survives(51,
             "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nv 2 2 2\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//2 4//1\nf -1 1/1 "
             "2/2/2\nf 1 2 3 4 5\n",
             read_obj);
}
TEST(DamagedFile, AsciiPly) {
    survives(52, "ply\nformat ascii" + kPlyHeader + "0 0 0 1\n1 0 0 2\n1 1 0.5 3\n0 1 0 4\n4 0 1 2 3 0\n3 0 1 2 7\n",
             read_ply);
}
TEST(DamagedFile, BinaryPly) {
    std::string body;
    for (const float f : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f}) {
        body.append(reinterpret_cast<const char*>(&f), sizeof f);
        if (body.size() % 13 == 12) body += '\7';
    }
    for (const std::vector<int>& face : {std::vector<int>{0, 1, 2, 3}, std::vector<int>{0, 1, 2}}) {
        body += static_cast<char>(face.size());
        for (const int i : face) body.append(reinterpret_cast<const char*>(&i), sizeof i);
        body += '\1';
    }
    survives(53, "ply\nformat binary_little_endian" + kPlyHeader + body, read_ply);
}
TEST(DamagedFile, AsciiStl) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    survives(54, "solid s\n" + facet + facet + "endsolid s\n", read_stl);
}
TEST(DamagedFile, BinaryStl) {
    std::string bytes(80, 'x');
    bytes += std::string("\2\0\0\0", 4);
    for (int facet = 0; facet < 2; ++facet) {
        for (const float f : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 1.f * static_cast<float>(facet)})
            bytes.append(reinterpret_cast<const char*>(&f), sizeof f);
        bytes += std::string(2, '\0');
    }
    survives(55, bytes, read_stl);
}

}  // namespace
}  // namespace normalscope

// Files that other programs wrote, or might have: each once went wrong.

#include "core/mesh/mesh_file_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

fs::path input(const char* name) { return fs::path(MESH_INPUTS) / name; }

void expect_size(const char* name, std::size_t triangles, double area) {
    const Mesh mesh = load_mesh(input(name));
    EXPECT_EQ(mesh.triangles.size(), triangles) << name;
    EXPECT_NEAR(surface_area(mesh), area, 1e-6) << name;
}

TEST(MeshInputs, AreCubes) {
    for (const char* name :
         {"camera-element-none.ply", "camera-element-first.ply", "camera-element-first-binary.ply", "continued_f.obj",
          "bom.obj", "missing_vn.obj", "mixed.obj", "nan-normals-ascii.ply", "blank-line.ply", "face-first.ply"}) {
        expect_size(name, 12, 8.0);
        // Flat faces, whatever was the reason to compute normals.
        const Mesh mesh = load_mesh(input(name));
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 n = glm::normalize(
                glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]));
            for (int k = 0; k < 3; ++k) EXPECT_GT(glm::dot(n, mesh.normals[t[k]]), 1.0 - 1e-9) << name;
        }
    }
    EXPECT_FALSE(load_mesh(input("missing_vn.obj")).notes.empty());
}

TEST(MeshInputs, AreReadInFull) {
    EXPECT_EQ(load_mesh(input("before.ply")).triangles.size(), 1u);
    expect_size("tristrips.ply", 128, 2.45202624);
    for (const char* name : {"uppercase.stl", "leading-blank-line.stl", "trailing-bytes.stl"})
        EXPECT_EQ(load_mesh(input(name)).triangles.size(), 2u) << name;
    const auto notes = load_mesh(input("trailing-bytes.stl")).notes;
    EXPECT_TRUE(std::ranges::any_of(notes, [](const std::string& note) {
        return note.find("byte") != std::string::npos || note.find("after") != std::string::npos;
    }));
}

TEST(MeshInputs, AreRefusedInOneLine) {
    for (const char* name : {"flt.obj", "4v.stl"}) try {
            load_mesh(input(name));
            FAIL() << name << " was read";
        } catch (const InputError& error) {
            const std::string line = error.what();
            EXPECT_NE(line.find(name), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
}

// A sphere of 65 cm, where a survey's coordinates place it: as floats half a metre is all that they tell.
TEST_F(MeshFile, FarFromTheOriginIsAsNear) {
    constexpr int kRound = 48, kDown = 24;
    std::string vertices, obj_faces, ply_faces;
    const auto at = [&](int i, int j) { return j * kRound + i % kRound; };
    char line[128];
    for (int j = 0; j <= kDown; ++j)
        for (int i = 0; i < kRound; ++i) {
            const double u = 2.0 * std::numbers::pi * i / kRound, v = std::numbers::pi * (j + 0.5) / (kDown + 1);
            std::snprintf(line, sizeof line, "%.6f %.6f %.6f\n", 403212.4 + 0.653 * std::sin(v) * std::cos(u),
                          5604876.7 + 0.653 * std::cos(v), 112.3 + 0.653 * std::sin(v) * std::sin(u));
            vertices += line;
            if (j == kDown) continue;
            std::snprintf(line, sizeof line, "%d %d %d %d\n", at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            ply_faces += std::string("4 ") + line;
            std::snprintf(line, sizeof line, "f %d %d %d %d\n", at(i, j) + 1, at(i + 1, j) + 1, at(i + 1, j + 1) + 1,
                          at(i, j + 1) + 1);
            obj_faces += line;
        }
    std::string obj;
    for (std::size_t from = 0; from < vertices.size();) {
        const std::size_t end = vertices.find('\n', from) + 1;
        obj += "v " + vertices.substr(from, end - from);
        from = end;
    }
    const std::string header = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(kRound * (kDown + 1)) +
                               "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                               std::to_string(kRound * kDown) +
                               "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Mesh& mesh : {load("utm.obj", obj + obj_faces), load("utm.ply", header + vertices + ply_faces)}) {
        EXPECT_NEAR(surface_area(mesh), 4.0 * std::numbers::pi, 0.1);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            EXPECT_GT(glm::dot(glm::normalize(mesh.positions[i]), mesh.normals[i]), std::cos(0.08));
    }
}

// Beside the project, where there are any; or wherever the environment says.
TEST(MeshInputs, RealMeshes) {
    const char* given = std::getenv("NORMALSCOPE_MESHES");
    const fs::path folder = given ? fs::path(given) : fs::path(MESH_INPUTS) / "../../../../../shared/meshes";
    if (!fs::exists(folder / "spot.obj")) GTEST_SKIP() << "there are no meshes in " << folder;
    for (const char* name : {"spot.obj", "teapot.obj", "suzanne.obj", "cow.obj", "fandisk.obj"}) {
        const Mesh mesh = load_mesh(folder / name);
        expect_sound(mesh);
        EXPECT_GE(mesh.triangles.size(), 900u) << name;
        EXPECT_EQ(mesh.notes.empty(), mesh.normal_source == NormalSource::File) << name;
        for (const glm::dvec3& n : mesh.normals) EXPECT_NE(n, glm::dvec3(0.0)) << name;
    }
}

}  // namespace
}  // namespace normalscope

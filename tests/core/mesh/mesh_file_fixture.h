#pragma once

// Mesh files as texts, and what is asked of every mesh.

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/temporary_folder.h"
#include "core/mesh/mesh_file.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>

namespace normalscope {

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

inline void expect_sound(const Mesh& mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_FALSE(mesh.triangles.empty());
    double farthest = 0.0;
    for (const glm::dvec3& p : mesh.positions) farthest = std::max(farthest, glm::length(p));
    EXPECT_NEAR(farthest, 1.0, 1e-12);
    for (const glm::dvec3& n : mesh.normals)
        EXPECT_TRUE(n == glm::dvec3(0.0) || std::abs(glm::length(n) - 1.0) < 1e-12);
    for (const glm::uvec3& t : mesh.triangles) EXPECT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
    EXPECT_TRUE(mesh.face_of_triangle.empty() || mesh.face_of_triangle.size() == mesh.triangles.size());
    EXPECT_TRUE(std::ranges::is_sorted(mesh.face_of_triangle));
}

template <class T>
std::string bytes_of(T value, bool big_endian = false) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (big_endian == (std::endian::native == std::endian::little)) std::reverse(std::begin(bytes), std::end(bytes));
    return {bytes, sizeof value};
}

class MeshFile : public testing::Test {
protected:
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    Mesh load(const std::string& name, const std::string& bytes) const {
        write_file(path(name), bytes);
        return load_mesh(path(name));
    }
    // The error, which must be one line that begins with the file.
    std::string error(const std::string& name, const std::string& bytes) const {
        try {
            load(name, bytes);
        } catch (const InputError& e) {
            const std::string message = e.what();
            EXPECT_TRUE(message.starts_with(path(name) + ": ")) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            EXPECT_LT(message.size(), path(name).size() + 250) << message;
            return message.substr(path(name).size());
        }
        ADD_FAILURE() << name << " was read";
        return "";
    }
    // The only note on the mesh.
    static std::string note(const Mesh& mesh) {
        EXPECT_EQ(mesh.notes.size(), 1u);
        return mesh.notes.empty() ? "" : mesh.notes.front();
    }
    // A cube without normals: 12 triangles of flat faces, and the note that says so.
    void expect_cube(const std::string& name, const std::string& bytes) const {
        SCOPED_TRACE(name + ":\n" + bytes.substr(0, 200));
        const Mesh mesh = load(name, bytes);
        expect_sound(mesh);
        EXPECT_EQ(mesh.triangles.size(), 12u);
        EXPECT_NEAR(surface_area(mesh), 8.0, 1e-9);
        ASSERT_EQ(mesh.notes.size(), 1u);
        EXPECT_SAYS(mesh.notes[0], "computed, area-weighted, sharp where faces meet at more than 60°");
        for (const glm::uvec3& t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 n =
                    glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
                EXPECT_LT(glm::length(mesh.normals[t[k]] - glm::normalize(n)), 1e-12);
            }
    }

private:
    const TemporaryFolder temporary_{std::filesystem::path(testing::TempDir()) / "normalscope-mesh"};
    const std::filesystem::path& folder_ = temporary_.path();
};

}  // namespace normalscope

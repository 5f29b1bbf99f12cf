#include "core/mesh/mesh_file.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/temporary_folder.h"
#include "core/surface/shapes.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>

namespace normalscope {
namespace {

namespace fs = std::filesystem;

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

private:
    const TemporaryFolder temporary_{fs::path(testing::TempDir()) / "normalscope-mesh"};
    const fs::path& folder_ = temporary_.path();
};

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

void expect_sound(const Mesh& mesh) {
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

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(MeshFile, ObjWithoutNormalsComputesThem) {
    const Mesh mesh = load("a.obj", kTriangle + "f 1 2 3\n");
    expect_sound(mesh);
    EXPECT_EQ(mesh.normal_source, NormalSource::Computed);
    EXPECT_EQ(mesh.note, "a.obj has no normals: computed, area-weighted");
    for (const glm::dvec3& n : mesh.normals) EXPECT_EQ(n, glm::dvec3(0, 0, 1));
}

TEST_F(MeshFile, ObjNormalsAreThoseOfTheFile) {
    const Mesh mesh = load("a.obj", kTriangle + "vn 0 3 4\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(mesh.normal_source, NormalSource::File);
    EXPECT_EQ(mesh.note, "");
    EXPECT_EQ(mesh.positions.size(), 3u);
    for (const glm::dvec3& n : mesh.normals) EXPECT_LT(glm::length(n - glm::dvec3(0, 0.6, 0.8)), 1e-7);
    // A corner with two normals is two vertices, and one that lacks a normal gets a computed one.
    const Mesh crease =
        load("b.obj", kTriangle + "v 1 1 0\nvn 0 0 1\nvn 1 0 0\nvn 0 0 0\nf 1//1 2//1 3//1\nf 2//2 4//3 3//1\n");
    expect_sound(crease);
    EXPECT_EQ(crease.positions.size(), 5u);
    EXPECT_EQ(crease.note, "b.obj lacks 1 usable normal: computed, area-weighted");
    EXPECT_EQ(std::ranges::count(crease.normals, glm::dvec3(1, 0, 0)), 1);
    EXPECT_EQ(std::ranges::count(crease.normals, glm::dvec3(0, 0, 1)), 4);
}

TEST_F(MeshFile, ObjOddities) {
    for (const std::string& text :
         {kTriangle + "f -3 -2 -1\n", kTriangle + "f 1/1 2/2 3/3\n", kTriangle + "f 1 2 3",
          std::string("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"),
          std::string("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"),
          "mtllib missing.mtl\no thing\ng a b\ns off\nusemtl red\n" + kTriangle + "f 1 2 3\nl 1 2\n",
          std::string("# v nan\n  v 0 0 0 1 0.5 0.5 0.5 # red\n\tv\t1 0 0\nv +.1e1 1.E0 0\n\n  f 1 2 3\n")}) {
        const Mesh mesh = load("a.obj", text);
        expect_sound(mesh);
        EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}})) << text;
    }
}

TEST_F(MeshFile, ObjPolygonsKeepTheirIdentity) {
    // A quad, a concave pentagon whose fan from the first corner would be wrong, and a triangle.
    const Mesh mesh = load("a.obj",
                           "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 1 0\nv 0 0 4\n"
                           "f 1 4 6\nf 1 2 3 5 4\nf 4 3 2 1\n");
    expect_sound(mesh);
    EXPECT_EQ(mesh.triangles.size(), 6u);
    EXPECT_EQ(mesh.face_count(), 3u);
    EXPECT_EQ(mesh.face_of_triangle, (std::vector<std::uint32_t>{0, 1, 1, 1, 2, 2}));
    const std::vector<Site> sites = face_sites(mesh);
    ASSERT_EQ(sites.size(), 3u);
    EXPECT_EQ(sites[1].normal.xyz, glm::dvec3(0, 0, 1));
    double pentagon = 0.0, quad = 0.0;
    for (std::size_t i = 1; i < 6; ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        (i < 4 ? pentagon : quad) +=
            glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]).z;
    }
    EXPECT_NEAR(pentagon / quad, -10.0 / 16.0, 1e-12);  // no triangle of the pentagon is turned over
}

// The back of what is closed is not drawn: a hole or a part that is inside out would be seen through.
TEST_F(MeshFile, KnowsWhatIsClosed) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", open = "f 1 3 2\nf 1 2 4\nf 2 3 4\n";
    const std::string beside = "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n";
    EXPECT_TRUE(load("a.obj", corners + open + "f 3 1 4\n").closed);
    EXPECT_FALSE(load("a.obj", corners + open).closed);
    EXPECT_FALSE(load("a.obj", corners + open + "f 1 3 4\n").closed) << "one face is turned over";
    EXPECT_FALSE(load("a.obj", corners + "f 2 3 1\nf 4 2 1\nf 4 3 2\nf 4 1 3\n").closed) << "inside out";
    EXPECT_FALSE(load("a.obj", corners + open + "f 3 1 4\n" + beside + "f 6 7 5\nf 8 6 5\nf 8 7 6\nf 8 5 7\n").closed)
        << "one of two parts is inside out";
}

TEST_F(MeshFile, ObjNumbersAreReadAsCRoundsThem) {
    for (const std::string& x :
         {std::string("0.1"), std::string("123456.789012345"), std::string("3.14159265358979323846"),
          std::string("1234567890123456789"), std::string("1.7976931348623157e10"), std::string("5.e-1"),
          std::string("000000000000000000000.25"), std::string(".333333333333333333")}) {
        const Mesh mesh =
            load("a.obj", "v " + x + " 0 0\nv -" + x + " 0 0\nv 0 " + x + " 0\nv 0 -" + x + " 0\nf 1 3 2\nf 1 2 4\n");
        EXPECT_EQ(mesh.positions[0], glm::dvec3(1, 0, 0)) << x;
        EXPECT_EQ(mesh.positions[1], glm::dvec3(-1, 0, 0)) << x;
    }
}

TEST_F(MeshFile, FacesWithoutAreaAreLeftOut) {
    const Mesh mesh = load("a.obj", kTriangle + "v 2 0 0\nv 9 9 9\nf 1 2 4\nf 1 2 3\nf 1 1 3\nf 1 2\n");
    expect_sound(mesh);
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.positions.size(), 3u);
    EXPECT_SAYS(mesh.note, "3 faces without area left out");
}

TEST_F(MeshFile, SizeDoesNotMatter) {
    for (const char* scale : {"1e-30", "1e-5", "1e20", "9e29"}) {
        const std::string s = scale;
        const Mesh mesh = load("a.obj", "v 0 0 0\nv " + s + " 0 0\nv 0 " + s + " 0\nf 1 2 3\n");
        expect_sound(mesh);
        EXPECT_EQ(mesh.normals[0], glm::dvec3(0, 0, 1)) << scale;
    }
}

TEST_F(MeshFile, LargeFilesAreReadInPartsAlike) {
    // More than a part's worth of text; the relative indices of the second file forbid parts.
    std::string vertices, faces, relative;
    const int n = 90'000;
    for (int i = 0; i < n; ++i) {
        vertices +=
            "v " + std::to_string(i % 251) + " " + std::to_string(i / 251) + " " + std::to_string(i * 7 % 17) + "\n";
        if (i < 252) continue;
        faces += "f " + std::to_string(i) + " " + std::to_string(i - 1) + " " + std::to_string(i - 251) + "\n";
        relative += "f " + std::to_string(i - n - 1) + " " + std::to_string(i - n - 2) + " " +
                    std::to_string(i - n - 252) + "\n";
    }
    const Mesh one = load("a.obj", vertices + faces), two = load("b.obj", vertices + relative);
    EXPECT_GT(vertices.size() + faces.size(), std::size_t{2} << 20);
    EXPECT_EQ(one.triangles, two.triangles);
    EXPECT_EQ(one.positions, two.positions);
    EXPECT_SAYS(error("c.obj", vertices + faces + "v 1 2 x\n"), "line 179749");
}

TEST_F(MeshFile, BadObj) {
    EXPECT_SAYS(error("a.obj", ""), "empty");
    EXPECT_SAYS(error("a.obj", "# nothing\n"), "no vertices");
    EXPECT_SAYS(error("a.obj", kTriangle), "no faces");
    EXPECT_SAYS(error("a.obj", kTriangle + "f 1 2"), "no faces");
    EXPECT_SAYS(error("a.obj", kTriangle + "f 1 2 4\n"), "face 1 refers to a vertex that does not exist (there are 3)");
    for (const char* index : {"0", "-4", "999999999999", "-999999999999", "2147483647", "-2147483648", "x"})
        EXPECT_SAYS(error("a.obj", kTriangle + "f 1 2 3\nf 1 2 " + index + "\n"), "face 2 refers to a vertex");
    EXPECT_SAYS(error("a.obj", kTriangle + "vn 0 0 1\nf 1//1 2//1 3//2\n"), "refers to a normal");
    for (const char* number : {"nan", "NaN", "inf", "-inf", "x", "0x1", "1,5", ""})
        EXPECT_SAYS(error("a.obj", "v 0 0 0\nv 1 0 " + std::string(number) + "\n" + kTriangle + "f 1 2 3\n"),
                    "line 2: a vertex needs three numbers");
    for (const char* number : {"1e300", "-1e300", "1e31"})
        EXPECT_SAYS(error("a.obj", "v 0 0 0\nv 1 0 " + std::string(number) + "\n" + kTriangle + "f 1 2 3\n"),
                    "vertex 2 has a coordinate");
    EXPECT_SAYS(error("a.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"), "no area");
    std::string garbage;
    for (unsigned i = 0; i < 100'000; ++i) garbage += static_cast<char>(i * 2654435761u >> 24);
    for (const char* name : {"g.obj", "g.ply", "g.stl"}) error(name, garbage);
    // A concave face that would take minutes.
    std::string comb, face = "f";
    for (int i = 0; i < 5000; ++i) {
        comb += "v " + std::to_string(i) + " " + std::to_string(i % 2 ? 1 : i % 3 ? 5 : 9) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    EXPECT_SAYS(error("comb.obj", comb + "v 5000 -5 0\nv 0 -5 0\n" + face + " 5001 5002\n"), "concave face");
}

TEST_F(MeshFile, WhatIsNoReadableFile) {
    fs::create_directory(path("folder.obj"));
    for (const auto& [name, says] :
         std::vector<std::pair<std::string, std::string>>{{"folder.obj", "folder"},
                                                          {"missing.stl", "No such file"},
                                                          {"a.txt", ".obj, .ply or .stl"},
                                                          {"noending", ".obj, .ply or .stl"}})
        try {
            load_mesh(path(name));
            ADD_FAILURE() << name;
        } catch (const InputError& e) {
            EXPECT_SAYS(std::string(e.what()), says);
            EXPECT_TRUE(std::string(e.what()).starts_with(path(name) + ": "));
        }
}

// ---- PLY --------------------------------------------------------------------------------------------------------

template <class T>
std::string bytes_of(T value, bool big_endian = false) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (big_endian == (std::endian::native == std::endian::little)) std::reverse(std::begin(bytes), std::end(bytes));
    return {bytes, sizeof value};
}

std::string ply_header(const std::string& format, const std::string& vertices, const std::string& faces) {
    return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}
const std::string kAsciiSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

std::string binary_square(bool big_endian, float first = 0.0f, int last_index = 3) {
    std::string body;
    for (const float f : {first, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f})
        body += bytes_of(f, big_endian);
    body += '\4';
    for (const int i : {0, 1, 2, last_index}) body += bytes_of(i, big_endian);
    return body;
}

TEST_F(MeshFile, PlyOfEveryFormat) {
    for (const std::string& text : {ply_header("ascii", "4", "1") + kAsciiSquare,
                                    ply_header("binary_little_endian", "4", "1") + binary_square(false),
                                    ply_header("binary_big_endian", "4", "1") + binary_square(true)}) {
        const Mesh mesh = load("a.ply", text);
        expect_sound(mesh);
        EXPECT_EQ(mesh.positions.size(), 4u);
        EXPECT_EQ(mesh.triangles.size(), 2u);
        EXPECT_EQ(mesh.face_count(), 1u);
        EXPECT_EQ(mesh.normals[0], glm::dvec3(0, 0, 1));
        EXPECT_SAYS(mesh.note, "no normals");
    }
    const Mesh mesh = load(
        "n.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
        "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nelement face 1\n"
        "property list uchar uint vertex_index\nend_header\n0 0 0 0 0 2 255\n1 0 0 0 3 4 0\n0 1 0 0 0 0 1\n3 0 1 2\n");
    expect_sound(mesh);
    EXPECT_EQ(mesh.normal_source, NormalSource::File);
    EXPECT_LT(glm::length(mesh.normals[1] - glm::dvec3(0, 0.6, 0.8)), 1e-7);
    EXPECT_SAYS(mesh.note, "lacks 1 usable normal");
}

TEST_F(MeshFile, BadPly) {
    const std::string binary = ply_header("binary_little_endian", "4", "1") + binary_square(false);
    for (std::size_t cut = 1; cut < binary.size(); cut += 3) error("cut.ply", binary.substr(0, cut));
    const std::string ascii = ply_header("ascii", "4", "1") + kAsciiSquare;
    for (std::size_t cut = 1; cut + 2 < ascii.size(); cut += 3) error("cut.ply", ascii.substr(0, cut));
    // Claims of billions must cost neither memory nor time.
    for (const std::string format : {"ascii", "binary_little_endian"}) {
        const std::string body = format == "ascii" ? kAsciiSquare : binary_square(false);
        EXPECT_SAYS(error("huge.ply", ply_header(format, "4000000000", "1") + body), "4000000000");
        EXPECT_SAYS(error("huge.ply", ply_header(format, "4", "4000000000") + body), "4000000000");
        EXPECT_SAYS(error("huge.ply", ply_header(format, "99999999999999999999999", "1") + body), "count");
        EXPECT_SAYS(error("huge.ply", ply_header(format, "-4", "1") + body), "count");
    }
    EXPECT_SAYS(error("list.ply", ply_header("ascii", "4", "1") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4000000000 0 1 2 3\n"),
                "entry 1 of \"face\"");
    EXPECT_SAYS(error("nan.ply", ply_header("ascii", "4", "1") + "nan" + kAsciiSquare.substr(1)),
                "entry 1 of \"vertex\"");
    EXPECT_SAYS(error("nan.ply", ply_header("binary_little_endian", "4", "1") +
                                     binary_square(false, std::numeric_limits<float>::quiet_NaN())),
                "vertex 1 has a coordinate");
    EXPECT_SAYS(error("range.ply", ply_header("binary_little_endian", "4", "1") + binary_square(false, 0.f, 4)),
                "face 1 refers to a vertex");
    EXPECT_SAYS(error("range.ply", ply_header("binary_little_endian", "4", "1") + binary_square(false, 0.f, -1)),
                "face 1 refers to a vertex");
    EXPECT_SAYS(error("points.ply", ply_header("ascii", "4", "0") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"), "only points");
    EXPECT_SAYS(error("empty.ply", ""), "empty");
}

// ---- STL --------------------------------------------------------------------------------------------------------

const glm::vec3 kTetrahedron[4][3] = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                                      {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                                      {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

std::string ascii_stl() {
    std::string text = "solid tetrahedron\n";
    for (const auto& t : kTetrahedron) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const glm::vec3& p : t)
            text += "  vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid tetrahedron\n";
}
std::string binary_stl(std::uint32_t claimed, float first = 0.0f) {
    std::string bytes = "solid, though binary";
    bytes.resize(80, ' ');
    bytes += bytes_of(claimed);
    for (const auto& t : kTetrahedron) {
        for (int i = 0; i < 3; ++i) bytes += bytes_of(0.0f);
        for (const glm::vec3& p : t)
            for (int i = 0; i < 3; ++i)
                bytes += bytes_of(&t == &kTetrahedron[0] && &p == &t[0] && i == 0 ? first : p[i]);
        bytes += std::string(2, '\0');
    }
    return bytes;
}

TEST_F(MeshFile, StlIsWeldedAndSharpAtCreases) {
    for (const std::string& bytes : {ascii_stl(), binary_stl(4)}) {
        const Mesh mesh = load("a.STL", bytes);
        expect_sound(mesh);
        EXPECT_TRUE(mesh.closed);
        EXPECT_EQ(mesh.positions.size(), 12u);
        EXPECT_EQ(mesh.triangles.size(), 4u);
        EXPECT_EQ(mesh.note,
                  "a.STL has no vertex normals: computed, area-weighted, sharp where faces meet at more than 60°");
        for (const glm::uvec3& t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 n =
                    glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
                EXPECT_LT(glm::length(mesh.normals[t[k]] - glm::normalize(n)), 1e-12);
            }
    }
}

// Without its normals a shape is smooth where it was, and sharp where it was: as many vertices, alike in their normals.
TEST_F(MeshFile, CreasesAreThoseOfTheShapes) {
    for (const Shape shape : {Shape::Sphere, Shape::Cube, Shape::Cylinder, Shape::Torus, Shape::Dodecahedron}) {
        const Mesh exact = make_shape({shape, 24});
        std::map<std::array<double, 3>, std::size_t> welded;
        std::string obj;
        std::vector<std::size_t> index;
        for (const glm::dvec3& p : exact.positions) {
            const std::array<double, 3> key{std::round(1e9 * p.x) + 0.0, std::round(1e9 * p.y) + 0.0,
                                            std::round(1e9 * p.z) + 0.0};
            const auto [at, is_new] = welded.emplace(key, welded.size() + 1);
            if (is_new) {
                std::array<char, 100> line{};
                std::snprintf(line.data(), line.size(), "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
                obj += line.data();
            }
            index.push_back(at->second);
        }
        for (const glm::uvec3& t : exact.triangles)
            obj += "f " + std::to_string(index[t.x]) + " " + std::to_string(index[t.y]) + " " +
                   std::to_string(index[t.z]) + "\n";
        const Mesh mesh = load("s.obj", obj);
        expect_sound(mesh);
        EXPECT_TRUE(mesh.closed);
        ASSERT_EQ(mesh.triangles.size(), exact.triangles.size());
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k)
                EXPECT_GT(glm::dot(mesh.normals[mesh.triangles[i][k]], exact.normals[exact.triangles[i][k]]), 0.99)
                    << static_cast<int>(shape) << " triangle " << i;
    }
}

TEST_F(MeshFile, BadStl) {
    EXPECT_SAYS(error("a.stl", binary_stl(5)), "announces 5 facets");
    EXPECT_SAYS(error("a.stl", binary_stl(0xFFFFFFFFu)), "announces 4294967295 facets");
    EXPECT_SAYS(error("a.stl", binary_stl(4).substr(0, 150)), "announces 4 facets");
    EXPECT_SAYS(error("a.stl", binary_stl(4, std::numeric_limits<float>::infinity())), "coordinate");
    EXPECT_SAYS(error("a.stl", binary_stl(4, std::numeric_limits<float>::quiet_NaN())), "coordinate");
    EXPECT_SAYS(error("a.stl", ascii_stl().substr(0, 200)), "endsolid");
    EXPECT_SAYS(error("a.stl", "solid x\nendsolid x\n"), "faces");
    EXPECT_SAYS(error("a.stl", "hello"), "too short");
    error("a.stl", "");
    error("a.stl", binary_stl(0).substr(0, 84));
}

// ---- Real ones --------------------------------------------------------------------------------------------------

TEST_F(MeshFile, RealMeshes) {
    const char* given = std::getenv("NORMALSCOPE_MESHES");
    const fs::path folder = given ? fs::path(given) : fs::path(__FILE__).parent_path() / "../../../shared/meshes";
    if (!fs::exists(folder / "spot.obj")) GTEST_SKIP() << "there are no meshes in " << folder;
    for (const char* name : {"spot.obj", "teapot.obj", "suzanne.obj", "cow.obj", "fandisk.obj"}) {
        const Mesh mesh = load_mesh(folder / name);
        expect_sound(mesh);
        EXPECT_GE(mesh.triangles.size(), 900u) << name;
        EXPECT_EQ(mesh.note.empty(), mesh.normal_source == NormalSource::File) << name;
        for (const glm::dvec3& n : mesh.normals) EXPECT_NE(n, glm::dvec3(0.0)) << name;
    }
}

}  // namespace
}  // namespace normalscope

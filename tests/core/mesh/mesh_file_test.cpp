#include "core/mesh/mesh_file_fixture.h"
#include "core/surface/shapes.h"

#include <array>
#include <cstdio>
#include <map>

namespace normalscope {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(MeshFile, ObjWithoutNormalsComputesThem) {
    const Mesh mesh = load("a.obj", kTriangle + "f 1 2 3\n");
    expect_sound(mesh);
    EXPECT_EQ(mesh.normal_source, NormalSource::Computed);
    EXPECT_EQ(note(mesh), "a.obj has no normals: computed, area-weighted");
    for (const glm::dvec3& n : mesh.normals) EXPECT_EQ(n, glm::dvec3(0, 0, 1));
}

TEST_F(MeshFile, ObjNormalsAreThoseOfTheFile) {
    const Mesh mesh = load("a.obj", kTriangle + "vn 0 3 4\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(mesh.normal_source, NormalSource::File);
    EXPECT_TRUE(mesh.notes.empty());
    EXPECT_EQ(mesh.positions.size(), 3u);
    for (const glm::dvec3& n : mesh.normals) EXPECT_LT(glm::length(n - glm::dvec3(0, 0.6, 0.8)), 1e-7);
    // A corner with two normals is two vertices, and one that lacks a normal gets a computed one.
    const Mesh crease =
        load("b.obj", kTriangle + "v 1 1 0\nvn 0 0 1\nvn 1 0 0\nvn 0 0 0\nf 1//1 2//1 3//1\nf 2//2 4//3 3//1\n");
    expect_sound(crease);
    EXPECT_EQ(crease.positions.size(), 5u);
    EXPECT_EQ(note(crease), "b.obj lacks 1 usable normal: computed, area-weighted");
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

// Eight corners, and the faces by their numbers in them, each with what stands after its corners.
const std::string kCubeCorners = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
const std::string kCubeSides = "f 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";
const std::string kCube = kCubeCorners + "f 4 3 2 1\nf 5 6 7 8\n" + kCubeSides;

std::string with(const std::string& text, const std::string& from, const std::string& to) {
    std::string result;
    std::size_t begin = 0;
    for (std::size_t at = 0; (at = text.find(from, begin)) != text.npos; begin = at + from.size())
        result += text.substr(begin, at - begin) + to;
    return result + text.substr(begin);
}

TEST_F(MeshFile, ObjTextOfAnyHabit) {
    const std::string mark = "\xEF\xBB\xBF";
    expect_cube("a.obj", kCube);
    expect_cube("a.obj", mark + kCube);
    expect_cube("a.obj", mark + "\r\n\r\n" + with(kCube, "\n", "\r\n"));
    expect_cube("a.obj", "\n \n\t\n" + kCube);
    expect_cube("a.obj", with(with(kCube, "v", "V"), "f", "F"));
    expect_cube("a.obj", with(kCube, "f", "fo"));
    expect_cube("a.obj", with(kCube, "\n", " # f 1 2 x\n"));
    // A backslash at a line's end continues it, in any statement, but not in a comment.
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        expect_cube("a.obj", with(with(kCube, " ", " \\\n"), "\n", end));
        expect_cube("a.obj", with(with(kCube, " ", "\\\n "), "\n", end));
        expect_cube("a.obj", with("g sides \\\nf 1 2 3\n" + kCube, "\n", end));
        expect_cube("a.obj", with("vn 0 \\\n 0 1\n" + kCube, "\n", end));
        expect_cube("a.obj", with("# C:\\cubes\\\n" + kCube, "\n", end));
        expect_cube("a.obj", with("o cube # C:\\cubes\\\n" + kCube, "\n", end));
    }
    expect_cube("a.obj", kCube + "g \\\n");
}

// Whatever the reason: the file has none, names one that is not there, or one that is none.
TEST_F(MeshFile, ObjNormalsThatLackAreSharpAtCreases) {
    const auto top = [](const std::string& normals, const std::string& face) {
        return kCubeCorners + normals + "f 4 3 2 1\n" + face + "\n" + kCubeSides;
    };
    for (const std::string& text :
         {top("", "f 5/1/1 6/2/2 7/3/3 8/4/4"), top("", "f 5//1 6//-1 7//0 8"), top("vt 0 0\n", "f 5/1 6/1 7/1 8/1"),
          top("vt 0 0\nvn 0 0 1\n", "f 5/1/1 6//1 7/3 8"), top("vn 0 0 1\n", "f 5//1 6//2 7//99999999999 8//-2"),
          top("vn nan nan nan\n", "f 5//1 6//1 7//1 8//1"), top("vn 0 0\n", "f 5//1 6//1 7//1 8//1"),
          top("vn 0 0 0\nvn 1e999 0 0\nvn x y z\n", "f 5//1 6//2 7//3 8//3")})
        expect_cube("a.obj", text);
    EXPECT_SAYS(note(load("a.obj", top("", "f 5//1 6//2 7//3 8//4"))), "a.obj has no normals");
    EXPECT_SAYS(note(load("a.obj", top("vn 0 0 1\n", "f 5//1 6//1 7//1 8//2"))), "lacks 8 usable normals");
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
    ASSERT_EQ(mesh.notes.size(), 2u);
    EXPECT_SAYS(mesh.notes[1], "3 faces without area left out");
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
    EXPECT_SAYS(error("d.obj", vertices + faces + "f 1 2 90001\n"), "line 179749: face 89749 refers");
    // Parts are not cut where a line is continued.
    EXPECT_EQ(load("e.obj", with(vertices + faces, " ", " \\\n")).triangles, one.triangles);
    EXPECT_EQ(load("f.obj", with(vertices + faces, "\n", "\\\r\n\r\n")).triangles, one.triangles);
    EXPECT_EQ(load("g.obj", with(vertices + faces, "\n", "\r")).triangles, one.triangles);
    // A byte order mark counts for a place, and not for a line.
    EXPECT_SAYS(error("h.obj", "\xEF\xBB\xBF" + vertices + faces + "v 1 2 x\n"), "line 179749");
    EXPECT_SAYS(error("i.obj", "\xEF\xBB\xBF" + vertices + faces + "f 1 2 90001\n"), "line 179749: face 89749 refers");
}

TEST_F(MeshFile, CornersOfObjAsOthersWriteThem) {
    const std::string all = kTriangle + "vt 0 0\nvn 0 0 1\n";
    for (const char* corner : {"1", "+1", "1/", "1//", "1/1", "1/1/", "1//1", "1/1/1", "-3", "-3/-1/-1"})
        EXPECT_EQ(load("a.obj", all + "f " + corner + " 2 3\n").triangles.size(), 1u) << corner;
}

TEST_F(MeshFile, BadObj) {
    EXPECT_SAYS(error("a.obj", ""), "empty");
    EXPECT_SAYS(error("a.obj", "# nothing\n"), "no vertices");
    EXPECT_SAYS(error("a.obj", kTriangle), "no faces");
    EXPECT_SAYS(error("a.obj", kTriangle + "f 1 2"), "no faces");
    EXPECT_SAYS(error("a.obj", kTriangle + "f 1 2 4\n"), "face 1 refers to a vertex that does not exist (there are 3)");
    for (const char* index : {"0", "-4", "999999999999", "-999999999999", "2147483647", "-2147483648"})
        EXPECT_SAYS(error("a.obj", kTriangle + "f 1 2 3\nf 1 2 " + index + "\n"), "line 5: face 2 refers to a vertex");
    for (const char* corner :
         {"x", "3.0", "1.9", "1e0", "3/x", "3//1.5", "//1", "/1", "3/1/1/1", "3///", "3,2", "-", "+", "3-"})
        EXPECT_SAYS(error("a.obj", kTriangle + "\n# face 1\nf 1 2 3\nf 1 2 " + corner + "\n"),
                    "line 7: \"" + std::string(corner) + "\" is not a corner of a face");
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
    std::filesystem::create_directory(path("folder.obj"));
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

}  // namespace
}  // namespace normalscope

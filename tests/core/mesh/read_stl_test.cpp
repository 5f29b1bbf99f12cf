#include "core/mesh/mesh_file_fixture.h"

#include <cctype>
#include <limits>

namespace normalscope {
namespace {

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
        EXPECT_EQ(note(mesh),
                  "a.STL has no vertex normals: computed, area-weighted, sharp where faces meet at more than 60°");
        for (const glm::uvec3& t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 n =
                    glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
                EXPECT_LT(glm::length(mesh.normals[t[k]] - glm::normalize(n)), 1e-12);
            }
    }
}

TEST_F(MeshFile, StlTextOfAnyHabit) {
    const auto expect_tetrahedron = [&](const std::string& text, const std::string& last_note = "") {
        SCOPED_TRACE(text.substr(0, 200));
        const Mesh mesh = load("a.stl", text);
        EXPECT_EQ(mesh.triangles.size(), 4u);
        EXPECT_TRUE(mesh.closed);
        ASSERT_EQ(mesh.notes.size(), last_note.empty() ? 1u : 2u);
        EXPECT_EQ(mesh.notes.size() == 2 ? mesh.notes[1] : "", last_note);
    };
    const std::string text = ascii_stl();
    std::string capitals = text, returns = text, pairs;
    std::ranges::transform(text, capitals.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    std::ranges::replace(returns, '\n', '\r');
    for (const char c : text) pairs += c == '\n' ? "\r\n" : std::string(1, c);
    expect_tetrahedron(capitals);
    expect_tetrahedron(returns);
    expect_tetrahedron(pairs);
    expect_tetrahedron("\n \t\r\n  " + text);
    expect_tetrahedron("\xEF\xBB\xBF" + text);
    expect_tetrahedron("\xEF\xBB\xBF\n" + capitals + "\n\n");
    expect_tetrahedron("solid C:\\meshes\\" + text.substr(text.find('\n')));
    expect_tetrahedron("solid" + text.substr(text.find('\n')));
    expect_tetrahedron("solid empty\nendsolid empty\n" + text);
    expect_tetrahedron(text + "made by hand\n", "a.stl: what follows its last solid is left out");
    expect_tetrahedron(binary_stl(4) + std::string(2, '\0'), "a.stl: what follows its last facet is left out");
    std::string nan = text;
    nan.replace(nan.find("normal 0 0 0"), 12, "normal nan");
    expect_tetrahedron(nan);
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
    EXPECT_SAYS(error("a.stl", binary_stl(0)), "announces 0 facets");
    const auto broken = [&](const std::string& from, const std::string& to) {
        std::string text = ascii_stl();
        return error("a.stl", text.replace(text.find(from), from.size(), to));
    };
    EXPECT_SAYS(broken(" endloop", "  vertex 1 1 0\n endloop"),
                "line 7: is a facet's fourth vertex, and a facet has three");
    EXPECT_SAYS(broken("  vertex 0.000000 1.000000 0.000000\n", ""), "line 6: ends a facet of 2 vertices");
    EXPECT_SAYS(broken("0.000000", "0,0"), "line 4: a vertex needs three numbers");
    EXPECT_SAYS(broken("0.000000", "nan"), "line 4: a vertex needs three numbers");
    EXPECT_SAYS(broken("0.000000\n", "\n"), "line 4: a vertex needs three numbers");
    EXPECT_SAYS(broken("vertex", "vertices"), "line 4: has \"vertices\" where \"vertex\" or \"endloop\" should be");
    EXPECT_SAYS(broken("outer", "inner"), "line 3: has \"inner\" where \"outer\" should be");
    EXPECT_SAYS(broken("endfacet", "facet"), "line 8: has \"facet\" where \"endfacet\" should be");
    EXPECT_SAYS(broken("facet normal", "color"), "line 2: has \"color\" where \"facet\" or \"endsolid\" should be");
    EXPECT_SAYS(broken("endsolid", "end"), "has \"end\" where");
    error("a.stl", "");
    error("a.stl", binary_stl(0).substr(0, 84));
}

}  // namespace
}  // namespace normalscope

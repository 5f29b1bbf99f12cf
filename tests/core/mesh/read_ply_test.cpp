#include "core/mesh/mesh_file_fixture.h"

#include <array>
#include <cctype>
#include <limits>
#include <vector>

namespace normalscope {
namespace {

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
        EXPECT_SAYS(note(mesh), "no normals");
    }
    const Mesh mesh = load(
        "n.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
        "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nelement face 1\n"
        "property list uchar uint vertex_index\nend_header\n0 0 0 0 0 2 255\n1 0 0 0 3 4 0\n0 1 0 0 0 0 1\n3 0 1 2\n");
    expect_sound(mesh);
    EXPECT_EQ(mesh.normal_source, NormalSource::File);
    EXPECT_LT(glm::length(mesh.normals[1] - glm::dvec3(0, 0.6, 0.8)), 1e-7);
    EXPECT_SAYS(note(mesh), "lacks 1 usable normal");
}

/// A PLY file with one description in each format.
class PlyText {
public:
    explicit PlyText(const std::string& format) : format_(format), text_("ply\nformat " + format + " 1.0\n") {}
    static constexpr std::array<const char*, 3> kFormats{"ascii", "binary_little_endian", "binary_big_endian"};

    PlyText& line(const std::string& text) {
        text_ += text + "\n";
        return *this;
    }
    template <class... Values>
    PlyText& entry(Values... values) {
        (add(values), ...);
        if (format_ == "ascii") text_ += "\n";
        return *this;
    }
    PlyText& cube_vertices(bool with_normals = false) {
        for (const glm::vec3 p : {glm::vec3(-1, -1, -1),
                                  {1, -1, -1},
                                  {1, 1, -1},
                                  {-1, 1, -1},
                                  {-1, -1, 1},
                                  {1, -1, 1},
                                  {1, 1, 1},
                                  {-1, 1, 1}}) {
            constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
            if (with_normals)
                entry(p.x, p.y, p.z, kNone, kNone, kNone);
            else
                entry(p.x, p.y, p.z);
        }
        return *this;
    }
    PlyText& cube_faces() {
        for (const auto& f :
             {std::array{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {3, 0, 4, 7}})
            entry(std::uint8_t{4}, f[0], f[1], f[2], f[3]);
        return *this;
    }
    std::string operator()() const { return text_; }

private:
    template <class T>
    void add(T value) {
        if (format_ == "ascii")
            text_ += std::to_string(value) + " ";
        else
            text_ += bytes_of(value, format_ == "binary_big_endian");
    }
    std::string format_, text_;
};
const std::string kXyz = "property float x\nproperty float y\nproperty float z";
const std::string kVertices = "element vertex 8\n" + kXyz;
const std::string kFaces = "element face 6\nproperty list uchar int vertex_indices";

TEST_F(MeshFile, PlySkipsWhatIsNotOfASurface) {
    for (const char* format : PlyText::kFormats) {
        const std::string camera =
            "element camera 1\nproperty float view_px\nproperty double view_py\nproperty char on";
        const std::string lists = "element user 2\nproperty list uchar float weights\nproperty short id";
        const auto some_lists = [](PlyText& text) -> PlyText& {
            return text.entry(std::uint8_t{2}, 0.5f, 0.25f, std::int16_t{-7}).entry(std::uint8_t{0}, std::int16_t{8});
        };
        PlyText before(format), between(format), after(format), within(format);
        before.line(camera).line(lists).line(kVertices).line(kFaces).line("end_header");
        some_lists(before.entry(1.0f, 2.0, std::int8_t{3})).cube_vertices().cube_faces();
        expect_cube("before.ply", before());
        between.line("element nothing 4000000000").line(kVertices).line(lists).line(camera).line(kFaces);
        some_lists(between.line("end_header").cube_vertices()).entry(1.0f, 2.0, std::int8_t{3}).cube_faces();
        expect_cube("between.ply", between());
        after.line(kFaces).line(kVertices).line(lists).line("end_header").cube_faces().cube_vertices();
        expect_cube("after.ply", some_lists(after)());
        within.line("element vertex 8\nproperty uchar red\nproperty list uint short tags").line(kXyz);
        within.line("property double quality\nelement face 6\nproperty list uchar float texcoord");
        within.line("property list uint8 uint32 vertex_index\nproperty ushort flags\nend_header");
        for (int i = 0; i < 8; ++i)
            within.entry(std::uint8_t{255}, std::uint32_t{1}, std::int16_t{-1}, i & 1 ? 1.0f : -1.0f,
                         i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f, 0.5);
        for (const auto& f : {std::array{2u, 3u, 1u, 0u},
                              {4u, 5u, 7u, 6u},
                              {0u, 1u, 5u, 4u},
                              {3u, 2u, 6u, 7u},
                              {1u, 3u, 7u, 5u},
                              {2u, 0u, 4u, 6u}})
            within.entry(std::uint8_t{1}, 0.5f, std::uint8_t{4}, f[0], f[1], f[2], f[3], std::uint16_t{9});
        expect_cube("within.ply", within());
    }
}

TEST_F(MeshFile, PlyTextOfAnyHabit) {
    for (const char* format : PlyText::kFormats) {
        const bool ascii = std::string(format) == "ascii";
        PlyText normals(format);
        normals.line("element vertex 8").line(kXyz).line("property float nx\nproperty float ny\nproperty float nz");
        normals.line(kFaces).line("end_header").cube_vertices(true).cube_faces();
        expect_cube("nan.ply", normals());

        PlyText plain(format);
        plain.line("comment property float w").line("obj_info by hand").line(kVertices).line(kFaces).line("end_header");
        const std::string header = plain(), body = plain.cube_vertices().cube_faces()().substr(header.size());
        expect_cube("plain.ply", header + body);
        for (const std::string end : {"\r\n", "\r", " \n"}) {
            std::string ended;
            for (const char c : ascii ? header + body : header) ended += c == '\n' ? end : std::string(1, c);
            expect_cube("ends.ply", ended + (ascii ? "" : body));
        }
        std::string capitals = header;
        std::ranges::transform(capitals, capitals.begin(),
                               [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        expect_cube("capitals.ply", capitals + body);
        expect_cube("mark.ply", "\xEF\xBB\xBF\n \n" + header + body);
        const Mesh mesh = load("more.ply", header + body + "1 2 3");
        EXPECT_EQ(mesh.triangles.size(), 12u);
        ASSERT_EQ(mesh.notes.size(), 2u);
        EXPECT_EQ(mesh.notes[1], "more.ply: what follows its last element is left out");
        if (!ascii) continue;
        expect_cube("blank.ply", header + "\n\n" + body + "\n\n");
        std::string words = body;
        std::ranges::replace(words, ' ', '\n');
        expect_cube("words.ply", header + words);
    }
    // A line end of one character before data that begins with what looks like the other.
    for (const std::string end : {"\r", "\n"}) {
        std::string text;
        for (const char c : std::string("ply\nformat binary_little_endian 1.0\nelement extra 1\nproperty uchar a\n") +
                                ply_header("", "4", "1").substr(std::string("ply\nformat  1.0\n").size()))
            text += c == '\n' ? end : std::string(1, c);
        EXPECT_EQ(load("end.ply", text + '\n' + binary_square(false)).triangles.size(), 2u);
        EXPECT_EQ(load("end.ply", text + '\r' + binary_square(false)).triangles.size(), 2u);
    }
}

TEST_F(MeshFile, PlyStrips) {
    for (const char* format : PlyText::kFormats) {
        // A square of two triangles, one alone, and one that follows a detour; the last is a face of its own.
        PlyText strips(format);
        strips.line("element vertex 6").line(kXyz).line("element tristrips 2\nproperty list int int vertex_indices");
        strips.line("element face 1\nproperty list uchar int vertex_indices\nend_header");
        for (const glm::vec3 p : {glm::vec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}})
            strips.entry(p.x, p.y, p.z);
        strips.entry(9, 0, 1, 2, 3, -1, 2, 3, 4, -1).entry(2, 4, 5).entry(std::uint8_t{3}, 3, 5, 4);
        const Mesh mesh = load("s.ply", strips());
        EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {3, 5, 4}}));
        for (const glm::dvec3& n : mesh.normals) EXPECT_EQ(n, glm::dvec3(0, 0, 1));
        EXPECT_EQ(mesh.notes.size(), 1u);
    }
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 4\n" + kXyz +
                               "\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                               "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
    // Two equal corners lead on, and the turn alternates past them.
    EXPECT_EQ(load("s.ply", header + "6 0 1 2 2 3 1\n").triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {3, 2, 1}}));
    EXPECT_SAYS(error("s.ply", header + "4 0 1 2 4\n"), "line 14: tristrips 1 refers to a vertex");
    EXPECT_SAYS(error("s.ply", header + "4 0 1 2 -2\n"), "tristrips 1 refers to a vertex");
}

// 0.1 and its like far from the origin: floats would leave steps.
TEST_F(MeshFile, PlyKeepsDoubles) {
    for (const char* format : PlyText::kFormats) {
        PlyText far(format);
        far.line("element vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1");
        far.line("property list uchar int vertex_indices\nend_header");
        far.entry(5604876.75, 0.0, 0.0).entry(5604876.8125, 0.0, 0.0).entry(5604876.75, 0.09375, 0.0);
        far.entry(std::uint8_t{3}, 0, 1, 2);
        const Mesh mesh = load("far.ply", far());
        EXPECT_NEAR(surface_area(mesh), 12.0 / 13.0, 1e-9);
    }
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
    for (const std::string word : {"nan", "-1.#IND", "inf", "x", "1,5"})
        EXPECT_SAYS(error("nan.ply", ply_header("ascii", "4", "1") + word + kAsciiSquare.substr(1)),
                    "line 11: vertex 1 has a coordinate that is not a number");
    for (const std::string word : {"1.9", "1e0", "x", "nan", "0x1", "-"})
        EXPECT_SAYS(
            error("face.ply", ply_header("ascii", "4", "1") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 " + word + "\n"),
            "line 15: entry 1 of \"face\"");
    EXPECT_SAYS(error("more.ply", ply_header("ascii", "4", "1") + "0 0 0 7\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"),
                "line 11: entry 1 of \"vertex\" has more numbers");
    EXPECT_SAYS(error("range.ply", ply_header("ascii", "4", "1") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 4\n"),
                "line 15: face 1 refers to a vertex that does not exist (there are 4)");
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

}  // namespace
}  // namespace normalscope

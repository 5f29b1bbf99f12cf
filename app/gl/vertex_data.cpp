#include "gl/vertex_data.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_precision.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <ranges>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

constexpr GLuint kPosition = 0, kNormal = 1, kOwnColor = 2, kSitePoint = 3, kSiteNormal = 4;  // scene.vert

void bind_and_fill(const GlBuffer& buffer, GLenum kind, std::size_t bytes, const void* data,
                   GLenum usage = GL_STATIC_DRAW) {
    glBindBuffer(kind, buffer.id());
    glBufferData(kind, static_cast<GLsizeiptr>(bytes), data, usage);
}

void attribute(GLuint index, GLint components, GLenum type, std::size_t stride, std::size_t offset,
               GLuint divisor = 0) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, components, type, type == GL_UNSIGNED_BYTE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(index, divisor);
}

struct Vertex {
    glm::vec3 position, normal;
    glm::u8vec4 own_color{0};
};

struct SiteVertex {
    glm::vec3 point, normal;
};

void fill_scene_vertices(const GlVertexArray& array, const GlBuffer& vertices, std::span<const Vertex> data) {
    glBindVertexArray(array.id());
    bind_and_fill(vertices, GL_ARRAY_BUFFER, data.size_bytes(), data.data());
    attribute(kPosition, 3, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, position));
    attribute(kNormal, 3, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, normal));
    attribute(kOwnColor, 4, GL_UNSIGNED_BYTE, sizeof(Vertex), offsetof(Vertex, own_color));
}

constexpr std::array<SiteVertex, 1> kNoSites{};  // for what is no arrow

SiteVertex site_vertex(const Site& site) { return {site.point.xyz, site.normal.xyz}; }

// The first instance's site is this one of the bound buffer.
void point_at_sites(std::size_t first) {
    const std::size_t offset = first * sizeof(SiteVertex);
    attribute(kSitePoint, 3, GL_FLOAT, sizeof(SiteVertex), offset + offsetof(SiteVertex, point), 1);
    attribute(kSiteNormal, 3, GL_FLOAT, sizeof(SiteVertex), offset + offsetof(SiteVertex, normal), 1);
}

void fill_sites(const GlBuffer& sites, std::span<const SiteVertex> data) {
    bind_and_fill(sites, GL_ARRAY_BUFFER, data.size_bytes(), data.data());
    point_at_sites(0);
}

// So many arrows leave each a few pixels: a shaft and a head of a triangle each, turned to the eye.
constexpr std::size_t kFlatFrom = 20'000;
constexpr int kFlat = 4;
// So many leave none to be seen by itself: needles, of one triangle.
constexpr std::size_t kNeedlesFrom = 300'000;
constexpr int kNeedle = 2;

// The fewer arrows, the rounder each: their triangles are what a frame costs on a processor. scene.vert turns the shaft's
// one half to the eye.
std::vector<Vertex> arrow_shape(int head_sides) {
    constexpr float kSlant = ArrowProportions::kHeadRadius / ArrowProportions::kHeadLength;
    const int half = head_sides / 2;
    // On a ring at a multiple of the angle between the head's sides.
    const auto corner = [&](float step, float radius, float along, float outward, float axial) {
        const float a = glm::two_pi<float>() * step / static_cast<float>(head_sides);
        const glm::vec2 out(std::cos(a), std::sin(a));
        return Vertex{{radius * out, along}, {outward * out, axial}};
    };
    const auto on_shaft = [&](int i, float along) {
        return corner(static_cast<float>(i * half) / static_cast<float>(half - 1), 1.0f, along, 1.0f, 0.0f);
    };
    const auto on_head = [&](int i, float radius, float along, float outward, float axial) {
        return corner(static_cast<float>(i), radius, along, outward, axial);
    };
    constexpr float kWide = ArrowProportions::kHeadRadius;
    if (head_sides == kNeedle)
        return {corner(0.0f, 1.5f, 0.0f, 1.0f, 0.0f), corner(1.0f, 1.5f, 0.0f, 1.0f, 0.0f),
                corner(0.5f, 0.0f, 2.0f, 1.0f, 0.0f)};
    if (head_sides == kFlat)  // the head's corners are those of its outline, seen from the side
        return {on_shaft(0, 0.0f),
                on_shaft(1, 0.0f),
                corner(1.0f, 0.0f, 2.0f, 1.0f, 0.0f),
                on_head(0, kWide, 1.0f, 1.0f, kSlant),
                on_head(half, kWide, 1.0f, 1.0f, kSlant),
                corner(1.0f, 0.0f, 2.0f, 1.0f, kSlant)};
    std::vector<Vertex> corners;
    for (int i = 0; i < half - 1; ++i) {
        const Vertex a = on_shaft(i, 0.0f), b = on_shaft(i + 1, 0.0f), c = on_shaft(i + 1, 1.0f), d = on_shaft(i, 1.0f);
        corners.insert(corners.end(), {a, b, c, a, c, d});
    }
    for (int i = 0; i < head_sides; ++i)
        corners.insert(corners.end(), {on_head(i, kWide, 1.0f, 1.0f, kSlant), on_head(i + 1, kWide, 1.0f, 1.0f, kSlant),
                                       corner(static_cast<float>(i) + 0.5f, 0.0f, 2.0f, 1.0f, kSlant)});
    for (int i = 1; i + 1 < head_sides; ++i)  // under the head
        corners.insert(corners.end(), {on_head(0, kWide, 1.0f, 0.0f, -1.0f), on_head(i + 1, kWide, 1.0f, 0.0f, -1.0f),
                                       on_head(i, kWide, 1.0f, 0.0f, -1.0f)});
    return corners;
}

}  // namespace

PaneVertices::PaneVertices() {
    constexpr std::array kCorners{-1.0f, -1.0f, 3.0f, -1.0f, -1.0f, 3.0f};
    glBindVertexArray(array_.id());
    bind_and_fill(corners_, GL_ARRAY_BUFFER, sizeof kCorners, kCorners.data());
    attribute(0, 2, GL_FLOAT, 2 * sizeof(float), 0);
}

void PaneVertices::draw() const {
    glBindVertexArray(array_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

TileVertices::TileVertices() {
    constexpr std::array kCorners{0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f};
    glBindVertexArray(array_.id());
    bind_and_fill(corners_, GL_ARRAY_BUFFER, sizeof kCorners, kCorners.data());
    attribute(0, 2, GL_FLOAT, 2 * sizeof(float), 0);
}

void TileVertices::draw(int count) const {
    glBindVertexArray(array_.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

MeshVertices::MeshVertices(const Mesh& mesh) : index_count_(static_cast<GLsizei>(3 * mesh.triangles.size())) {
    std::vector<Vertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = {mesh.positions[i], mesh.normals[i]};
    fill_scene_vertices(array_, vertices_, vertices);
    fill_sites(no_sites_, kNoSites);
    bind_and_fill(indices_, GL_ELEMENT_ARRAY_BUFFER, mesh.triangles.size() * sizeof(glm::uvec3), mesh.triangles.data());
}

void MeshVertices::draw() const {
    glBindVertexArray(array_.id());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

ArrowVertices::ArrowVertices(std::span<const Site> sites)
    : all_(sites), site_count_(static_cast<GLsizei>(sites.size())) {
    const std::size_t count = sites.size();
    const std::vector<Vertex> shape = arrow_shape(count >= kNeedlesFrom ? kNeedle
                                                  : count >= kFlatFrom  ? kFlat
                                                  : count > 60          ? 6
                                                                        : 8);
    shape_count_ = static_cast<GLsizei>(shape.size());
    fill_scene_vertices(array_, shape_, shape);
    fill_sites(sites_, {});  // when it is known in which order
}

// Where arrows hide one another by the thousand, the nearest are drawn first: what lies behind is not shaded. A coarse
// direction will do, and is kept while the eye hardly moves; but the order depends on nothing else, so that a picture
// is the same whatever was drawn before it.
void ArrowVertices::put_in_order(const glm::vec3& away_from_eye) {
    constexpr float kDirections = 6.0f;
    const bool any = all_.size() < kFlatFrom || !(glm::dot(away_from_eye, away_from_eye) > 0.0f);
    const glm::ivec3 order(any ? glm::vec3(0.0f) : glm::round(kDirections * glm::normalize(away_from_eye)));
    if (std::exchange(order_, order) == order) return;

    constexpr std::size_t kLayers = 4096;
    const auto depth = [&](const Site& site) { return glm::dot(glm::dvec3(order), site.point.xyz); };
    const auto [near, far] = std::ranges::minmax(all_ | std::views::transform(depth));
    const double scale = far > near ? (kLayers - 1) / (far - near) : 0.0;
    const auto layer = [&](const Site& site) { return static_cast<std::size_t>(scale * (depth(site) - near)); };
    std::array<std::size_t, kLayers + 1> starts{};
    for (const Site& site : all_) ++starts[layer(site) + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<SiteVertex> sorted(all_.size());
    for (const Site& site : all_) sorted[starts[layer(site)]++] = site_vertex(site);
    bind_and_fill(sites_, GL_ARRAY_BUFFER, sorted.size() * sizeof(SiteVertex), sorted.data());
}

void ArrowVertices::draw(const glm::vec3& away_from_eye) {
    if (site_count_ == 0) return;
    put_in_order(away_from_eye);
    // A software driver holds all vertices of a draw at once, after the shader: 2 GB for a million arrows.
    // What it then bins of several draws adds up as well, where it draws slower than it bins.
    constexpr GLsizei kBatch = 8192, kAhead = 8 * kBatch;
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, sites_.id());
    for (GLsizei first = 0; first < site_count_; first += kBatch) {
        if (site_count_ > kBatch) point_at_sites(static_cast<std::size_t>(first));
        if (first > 0 && first % kAhead == 0) glFinish();
        glDrawArraysInstanced(GL_TRIANGLES, 0, shape_count_, std::min(kBatch, site_count_ - first));
    }
}

SolidVertices::SolidVertices() {
    fill_scene_vertices(array_, vertices_, {});
    fill_sites(no_sites_, kNoSites);
}

void SolidVertices::draw(const Solids& solids) {
    if (solids.empty()) return;
    std::vector<Vertex> vertices(solids.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {solids[i].position, solids[i].normal, glm::u8vec4(glm::round(255.0f * solids[i].color))};
    glBindVertexArray(array_.id());
    bind_and_fill(vertices_, GL_ARRAY_BUFFER, vertices.size() * sizeof(Vertex), vertices.data(), GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(solids.size()));
}

}  // namespace normalscope

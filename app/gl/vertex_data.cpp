#include "gl/vertex_data.h"

#include "gl/vertex_layout.h"

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace normalscope {

namespace {

// The fewer arrows, the rounder each: their triangles are what a frame costs on a processor. scene.vert turns the shaft's
// one half to the eye.
std::vector<Vertex> arrow_shape(int head_sides, ArrowLook look) {
    constexpr float kSlant = ArrowProportions::kHeadRadius / ArrowProportions::kHeadLength;
    const int half = head_sides / 2;
    const float width = look == ArrowLook::Dashed ? ArrowProportions::kDashedWidth : 1.0f;
    // On a ring at a multiple of the angle between the head's sides.
    const auto corner = [&](float step, float radius, float along, float outward, float axial) {
        const float a = glm::two_pi<float>() * step / static_cast<float>(head_sides);
        const glm::vec2 out(std::cos(a), std::sin(a));
        return Vertex{{width * radius * out, along}, {outward * out, axial}};
    };
    const auto on_shaft = [&](int i, float along) {
        return corner(static_cast<float>(i * half) / static_cast<float>(half - 1), 1.0f, along, 1.0f, 0.0f);
    };
    const auto on_head = [&](int i, float radius, float along, float outward, float axial) {
        return corner(static_cast<float>(i), radius, along, outward, axial);
    };
    constexpr float kWide = ArrowProportions::kHeadRadius;
    std::vector<Vertex> corners;
    const int pieces = look == ArrowLook::Dashed ? ArrowProportions::kDashes : 1;
    for (int piece = 0; piece < pieces; ++piece) {
        const float each = 1.0f / static_cast<float>(2 * pieces - 1), from = static_cast<float>(2 * piece) * each,
                    to = piece + 1 == pieces ? 1.0f : from + each;
        for (int i = 0; i < half - 1; ++i) {
            const Vertex a = on_shaft(i, from), b = on_shaft(i + 1, from), c = on_shaft(i + 1, to), d = on_shaft(i, to);
            corners.insert(corners.end(), {a, b, c, a, c, d});
        }
    }
    const auto head = [&](float wide, float tip, bool inside_out) {
        const std::size_t first = corners.size();
        for (int i = 0; i < head_sides; ++i)
            corners.insert(corners.end(),
                           {on_head(i, wide, 1.0f, 1.0f, kSlant), on_head(i + 1, wide, 1.0f, 1.0f, kSlant),
                            corner(static_cast<float>(i) + 0.5f, 0.0f, tip, 1.0f, kSlant)});
        for (int i = 1; i + 1 < head_sides; ++i)  // under the head
            corners.insert(corners.end(), {on_head(0, wide, 1.0f, 0.0f, -1.0f), on_head(i + 1, wide, 1.0f, 0.0f, -1.0f),
                                           on_head(i, wide, 1.0f, 0.0f, -1.0f)});
        for (std::size_t i = first; inside_out && i < corners.size(); i += 3) std::swap(corners[i], corners[i + 1]);
    };
    head(kWide, 2.0f, look == ArrowLook::Hollow);
    if (look != ArrowLook::Hollow) return corners;
    // Turned inside out, the head shows its far side only: a rim about a smaller one of paper.
    const std::size_t first = corners.size();
    head(ArrowProportions::kHollow * kWide, 1.0f + ArrowProportions::kHollow, false);
    for (std::size_t i = first; i < corners.size(); ++i) corners[i].own_color = glm::u8vec4(255);
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

ArrowVertices::ArrowVertices(std::span<const Site> sites, ArrowLook look)
    : site_count_(static_cast<GLsizei>(sites.size())) {
    const std::vector<Vertex> shape = arrow_shape(sites.size() > 60 ? 6 : 8, look);
    shape_count_ = static_cast<GLsizei>(shape.size());
    std::vector<SiteVertex> vertices;
    for (const Site& site : sites) vertices.push_back(site_vertex(site));
    fill_scene_vertices(array_, shape_, shape);
    fill_sites(sites_, vertices);
}

void ArrowVertices::draw() const {
    glBindVertexArray(array_.id());
    glDrawArraysInstanced(GL_TRIANGLES, 0, shape_count_, site_count_);
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

#pragma once

#include "core/mesh/mesh.h"
#include "gl/objects.h"

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace normalscope {

// How scene.vert reads buffers.

inline constexpr GLuint kPosition = 0, kNormal = 1, kOwnColor = 2, kSitePoint = 3, kSiteNormal = 4;  // scene.vert

inline void bind_and_fill(const GlBuffer& buffer, GLenum kind, std::size_t bytes, const void* data,
                          GLenum usage = GL_STATIC_DRAW) {
    glBindBuffer(kind, buffer.id());
    glBufferData(kind, static_cast<GLsizeiptr>(bytes), data, usage);
}

inline void attribute(GLuint index, GLint components, GLenum type, std::size_t stride, std::size_t offset,
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

inline void fill_scene_vertices(const GlVertexArray& array, const GlBuffer& vertices, std::span<const Vertex> data) {
    glBindVertexArray(array.id());
    bind_and_fill(vertices, GL_ARRAY_BUFFER, data.size_bytes(), data.data());
    attribute(kPosition, 3, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, position));
    attribute(kNormal, 3, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, normal));
    attribute(kOwnColor, 4, GL_UNSIGNED_BYTE, sizeof(Vertex), offsetof(Vertex, own_color));
}

inline constexpr std::array<SiteVertex, 1> kNoSites{};  // for what is no arrow

inline SiteVertex site_vertex(const Site& site) { return {site.point.xyz, site.normal.xyz}; }

/// The bound buffer's sites, from this one on: one an instance (a divisor of 1) or one a vertex (0).
inline void point_at_sites(std::size_t first, GLuint divisor) {
    const std::size_t offset = first * sizeof(SiteVertex);
    attribute(kSitePoint, 3, GL_FLOAT, sizeof(SiteVertex), offset + offsetof(SiteVertex, point), divisor);
    attribute(kSiteNormal, 3, GL_FLOAT, sizeof(SiteVertex), offset + offsetof(SiteVertex, normal), divisor);
}

inline void fill_sites(const GlBuffer& sites, std::span<const SiteVertex> data) {
    bind_and_fill(sites, GL_ARRAY_BUFFER, data.size_bytes(), data.data());
    point_at_sites(0, 1);
}

}  // namespace normalscope

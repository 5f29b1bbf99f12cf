#include "gl/arrow_field.h"

#include "core/frame/solids.h"
#include "gl/driver.h"
#include "gl/vertex_layout.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace normalscope {

namespace {

constexpr float kWide = ArrowProportions::kHeadRadius, kSlant = kWide / ArrowProportions::kHeadLength;
// A shaft and a head of a triangle each, turned to the eye.
constexpr std::array<Vertex, 6> kFlat{{{{1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}},
                                       {{-1.0f, 0.0f, 0.0f}, {-1.0f, 0.0f, 0.0f}},
                                       {{0.0f, 0.0f, 2.0f}, {0.0f, 1.0f, 0.0f}},
                                       {{kWide, 0.0f, 1.0f}, {1.0f, 0.0f, kSlant}},
                                       {{-kWide, 0.0f, 1.0f}, {-1.0f, 0.0f, kSlant}},
                                       {{0.0f, 0.0f, 2.0f}, {0.0f, 1.0f, kSlant}}}};
// So many that none is to be seen by itself.
constexpr std::size_t kNeedlesFrom = 300'000;
constexpr std::array<Vertex, 3> kNeedle{{{{1.5f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}},
                                         {{-1.5f, 0.0f, 0.0f}, {-1.0f, 0.0f, 0.0f}},
                                         {{0.0f, 0.0f, 2.0f}, {0.0f, 1.0f, 0.0f}}}};

std::span<const Vertex> shape_of(std::size_t count) {
    if (count >= kNeedlesFrom) return kNeedle;
    return kFlat;
}

constexpr int kBoxCorners = 36;

void append_box(std::vector<glm::vec3>& corners, const WorldBox& box) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true})
            for (const int corner : {0, 1, 2, 2, 1, 3}) {
                glm::dvec3 at = far ? box.high : box.low;
                at[(axis + 1) % 3] = corner & 1 ? box.high[(axis + 1) % 3] : box.low[(axis + 1) % 3];
                at[(axis + 2) % 3] = corner & 2 ? box.high[(axis + 2) % 3] : box.low[(axis + 2) % 3];
                corners.emplace_back(at);
            }
}

}  // namespace

struct ArrowField::Part {
    const SiteCluster* cluster;
    WorldBox box;
    double depth = 0.0;        // of the box's middle
    bool always_seen = false;  // the near plane cuts the box, or there is none
    bool hidden = false;
};

// Plain vertices in place of instances: a software driver runs the shader for several at a time, but not for several
// instances.
ArrowField::ArrowField(std::span<const Site> sites) : site_count_(sites.size()) {
    const std::span<const Vertex> shape = shape_of(sites.size());
    corners_ = static_cast<GLsizei>(shape.size());
    std::vector<Vertex> shapes;
    for (std::size_t i = 0; i < SiteClusters::kMost; ++i) shapes.insert(shapes.end(), shape.begin(), shape.end());
    fill_scene_vertices(array_, shapes_, shapes);

    SiteClusters in_clusters = site_clusters(sites);
    clusters_ = std::move(in_clusters.clusters);
    const std::size_t bytes = sites.size() * shape.size() * sizeof(SiteVertex);
    bind_and_fill(sites_, GL_ARRAY_BUFFER, bytes, nullptr);
    // In parts: all of ten million arrows at once would be there twice.
    constexpr std::size_t kAtOnce = 16'384;
    std::vector<SiteVertex> part;
    GLintptr filled = 0;
    const auto send = [&] {
        const auto size = static_cast<GLsizeiptr>(part.size() * sizeof(SiteVertex));
        glBufferSubData(GL_ARRAY_BUFFER, filled, size, part.data());
        filled += size;
        part.clear();
    };
    for (const std::uint32_t i : in_clusters.order) {
        part.insert(part.end(), shape.size(), site_vertex(sites[i]));
        if (part.size() >= kAtOnce) send();
    }
    send();

    glBindVertexArray(box_array_.id());
    bind_and_fill(boxes_, GL_ARRAY_BUFFER, 0, nullptr);
    attribute(kPosition, 3, GL_FLOAT, sizeof(glm::vec3), 0);
}

std::vector<ArrowField::Part> ArrowField::front_to_back(const ArrowDraw& draw, const CameraView& view) const {
    const glm::dvec4 depth = glm::row(view.clip_from_world(), 3),
                     behind_near = glm::row(view.clip_from_world(), 2) + depth;
    std::vector<Part> parts;
    for (const SiteCluster& cluster : clusters_) {
        const std::optional<WorldBox> box = arrows_box(cluster, draw);
        Part& part = parts.emplace_back(&cluster, box.value_or(WorldBox{}));
        const glm::dvec3 middle = 0.5 * (part.box.low + part.box.high), half = part.box.high - middle;
        part.depth = glm::dot(depth, glm::dvec4(middle, 1.0));
        const double nearest =
            glm::dot(behind_near, glm::dvec4(middle, 1.0)) - glm::dot(glm::abs(glm::dvec3(behind_near)), half);
        part.always_seen = !box || !(nearest > 0.0);
    }
    std::ranges::stable_sort(parts, {}, &Part::depth);
    return parts;
}

void ArrowField::find_hidden(std::span<Part> parts, const CameraView& view) {
    std::vector<glm::vec3> corners;
    for (const Part& part : parts) append_box(corners, part.box);
    while (queries_.size() < parts.size()) queries_.emplace_back();
    glBindVertexArray(box_array_.id());
    bind_and_fill(boxes_, GL_ARRAY_BUFFER, corners.size() * sizeof(glm::vec3), corners.data(), GL_STREAM_DRAW);
    box_program_.use();
    box_program_.clip_from_world = glm::mat4(view.clip_from_world());
    glDisable(GL_CULL_FACE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].always_seen) continue;
        glBeginQuery(GL_ANY_SAMPLES_PASSED, queries_[i].id());
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(i) * kBoxCorners, kBoxCorners);
        glEndQuery(GL_ANY_SAMPLES_PASSED);
    }
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_CULL_FACE);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].always_seen) continue;
        GLuint seen = GL_TRUE;
        glGetQueryObjectuiv(queries_[i].id(), GL_QUERY_RESULT, &seen);
        parts[i].hidden = seen == GL_FALSE;
    }
}

void ArrowField::draw_parts(std::span<const Part> parts) const {
    // What a software driver bins of several draws adds up, where it draws slower than it bins: gigabytes.
    constexpr std::size_t kAhead = 65'536;
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, sites_.id());
    std::size_t ahead = 0;
    for (const Part& part : parts) {
        if (part.hidden) continue;
        point_at_sites(part.cluster->first * static_cast<std::size_t>(corners_), 0);
        glDrawArrays(GL_TRIANGLES, 0, corners_ * static_cast<GLsizei>(part.cluster->count));
        ahead += part.cluster->count;
        if (ahead < kAhead) continue;
        wait_for_pixels();
        ahead = 0;
    }
}

void ArrowField::draw(const SceneProgram& program, const ArrowDraw& draw, const CameraView& view) {
    std::vector<Part> parts = front_to_back(draw, view);
    // The surface and a quarter of its arrows hide nearly all that will be hidden.
    std::size_t nearest = 0;
    for (std::size_t sites = 0; sites < site_count_ / 4; ++nearest) sites += parts[nearest].cluster->count;
    const std::span<Part> first = std::span(parts).first(nearest), rest = std::span(parts).subspan(nearest);
    draw_parts(first);
    if (answers_at_once()) find_hidden(rest, view);
    program.use();
    draw_parts(rest);
}

}  // namespace normalscope

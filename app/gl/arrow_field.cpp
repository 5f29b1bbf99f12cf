#include "gl/arrow_field.h"

#include "core/frame/solids.h"
#include "gl/driver.h"
#include "gl/vertex_layout.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cstdint>
#include <random>

namespace normalscope {

namespace {

// So many that each is a few pixels; and so many that none is to be seen by itself.
constexpr std::size_t kDartsFrom = 50'000;
constexpr std::size_t kNeedlesFrom = 300'000;
// So many that it is worth asking what is hidden.
constexpr std::size_t kHidingFrom = 10'000;

// One arrow: what scene.vert turns to the eye about its axis, so that y points there as far as it can.
struct Outline {
    std::vector<Vertex> vertices;
    std::vector<GLuint> corners;  // three a triangle

    GLuint add(const glm::vec3& position, const glm::vec3& normal, glm::u8vec4 own_color) {
        vertices.push_back({position, normal, own_color});
        return static_cast<GLuint>(vertices.size()) - 1;
    }
    void add_triangle(GLuint a, GLuint b, GLuint c) { corners.insert(corners.end(), {a, b, c}); }
};

// In alpha whether it is paper, and in red how much of the light comes there between all the others: the tips stand out.
glm::u8vec4 own_color(float along, bool crowded, bool paper = false) {
    const float light = crowded ? 0.4f + 0.3f * along : 1.0f;
    return {static_cast<std::uint8_t>(255.0f * light), 0, 0, paper ? 255 : 0};
}

void add_shaft(Outline& outline, float width, float from, float to) {
    const auto corner = [&](float side, float along) {
        return outline.add({side * width, 0.0f, along}, {side, 0.0f, 0.0f}, own_color(along, false));
    };
    const GLuint a = corner(1.0f, from), b = corner(-1.0f, from), c = corner(-1.0f, to), d = corner(1.0f, to);
    outline.add_triangle(a, b, c);
    outline.add_triangle(a, c, d);
}

// Fewer triangles, for what is a few pixels. One that leans has its base so far from the axis, on the eye's side where it points to the
// eye, and its tip as far on the other: end-on it covers as much as what is round, and from the side as if it did not lean.
void add_taper(Outline& outline, float width, float from, float lean = 0.0f) {
    const auto corner = [&](float side, float y, float along, const glm::vec3& normal) {
        glm::u8vec4 color = own_color(along, true);
        color.g = lean > 0.0f ? 255 : 0;
        return outline.add({side * width, y, along}, normal, color);
    };
    const GLuint a = corner(1.0f, lean, from, {1.0f, 0.0f, 0.0f}), b = corner(-1.0f, lean, from, {-1.0f, 0.0f, 0.0f});
    outline.add_triangle(a, b, corner(0.0f, -lean, 2.0f, {0.0f, 1.0f, 0.0f}));
}

// A cone's outline from any side is that of a triangle and its base together. The base is a rhombus that is as wide as the
// solid one's hexagon across the line of sight, and has its area.
void add_head(Outline& outline, float wide, float tip, float nearer, bool crowded, bool paper) {
    constexpr float kSlant = ArrowProportions::kHeadRadius / ArrowProportions::kHeadLength, kAlong = 1.45f;
    const auto corner = [&](float x, float y, float along, const glm::vec3& normal) {
        return outline.add({wide * x, wide * y + nearer, along}, normal, own_color(along, crowded, paper));
    };
    const GLuint right = corner(1.0f, 0.0f, 1.0f, {1.0f, 0.0f, kSlant}),
                 left = corner(-1.0f, 0.0f, 1.0f, {-1.0f, 0.0f, kSlant}),
                 near = corner(0.0f, kAlong, 1.0f, {0.0f, 1.0f, kSlant}),
                 far = corner(0.0f, -kAlong, 1.0f, {0.0f, -1.0f, kSlant});
    outline.add_triangle(right, left, corner(0.0f, 0.0f, tip, {0.0f, 1.0f, kSlant}));
    outline.add_triangle(right, near, left);
    outline.add_triangle(right, left, far);
}

Outline outline_of(ArrowLook look, bool crowded) {
    Outline outline;
    const int pieces = look == ArrowLook::Dashed ? ArrowProportions::kDashes : 1;
    const float width = look == ArrowLook::Dashed ? ArrowProportions::kDashedWidth : 1.0f,
                each = 1.0f / static_cast<float>(2 * pieces - 1);
    if (crowded) add_taper(outline, 1.0f, 0.0f);
    for (int piece = 0; piece < pieces && !crowded; ++piece) {
        const float from = static_cast<float>(2 * piece) * each;
        add_shaft(outline, width, from, from + each);
    }
    constexpr float kWide = ArrowProportions::kHeadRadius, kHollow = ArrowProportions::kHollow;
    add_head(outline, width * kWide, 2.0f, 0.0f, crowded, false);
    if (look == ArrowLook::Hollow) add_head(outline, kHollow * kWide, 1.0f + kHollow, 0.3f, crowded, true);
    return outline;
}

// A shaft and a head of one triangle each. What leans does so as far as it must for the surface's share of a picture to be what it
// is beneath solid arrows.
Outline dart() {
    constexpr float kWide = ArrowProportions::kHeadRadius;
    Outline outline;
    add_taper(outline, 1.0f, 0.0f);
    add_taper(outline, kWide, 1.0f, 1.2f * kWide);
    return outline;
}

Outline needle() {
    Outline outline;
    add_taper(outline, 1.5f, 0.0f, 3.5f);
    return outline;
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

ArrowField::ArrowField(std::span<const Site> sites)
    : sites_(sites),
      clustering_(beside([sites] { return site_clusters(sites); },
                         sites.size() < kHidingFrom ? Begin::WhenAsked : Begin::AtOnce)) {
    glBindVertexArray(box_array_.id());
    bind_and_fill(boxes_, GL_ARRAY_BUFFER, 0, nullptr);
    attribute(kPosition, 3, GL_FLOAT, sizeof(glm::vec3), 0);
}

const SiteClusters& ArrowField::in_clusters() {
    if (clustering_) in_clusters_ = clustering_.get();
    return in_clusters_;
}

bool ArrowField::has_heads() const { return sites_.size() < kNeedlesFrom; }

// Plain vertices in place of instances: a software driver runs the shader for several at a time, but not for several
// instances.
const ArrowField::Kind& ArrowField::kind(ArrowLook look) {
    const bool crowded = sites_.size() >= kManyArrows;
    if (crowded) look = ArrowLook::Plain;
    const auto [found, is_new] = kinds_.try_emplace(look);
    Kind& kind = found->second;
    if (!is_new) return kind;
    const Outline outline = !has_heads() ? needle() : sites_.size() >= kDartsFrom ? dart() : outline_of(look, crowded);
    kind.shape_vertices = static_cast<GLsizei>(outline.vertices.size());
    kind.shape_corners = static_cast<GLsizei>(outline.corners.size());
    const std::size_t most = std::min(SiteClusters::kMost, sites_.size());
    std::vector<Vertex> vertices;
    std::vector<GLuint> corners;
    std::mt19937 random;  // the same everywhere, by the standard
    for (std::size_t i = 0; i < most; ++i) {
        // Arrows that touch their neighbours would merge into a skin, if each had not more or less light than the next.
        const float light =
            crowded ? 0.5f + 0.5f * static_cast<float>(random()) / static_cast<float>(random.max()) : 1.0f;
        for (const GLuint corner : outline.corners) corners.push_back(static_cast<GLuint>(vertices.size()) + corner);
        for (Vertex vertex : outline.vertices) {
            vertex.own_color.r = static_cast<std::uint8_t>(light * static_cast<float>(vertex.own_color.r));
            vertices.push_back(vertex);
        }
    }
    fill_scene_vertices(kind.array, kind.shapes, vertices);
    bind_and_fill(kind.corners, GL_ELEMENT_ARRAY_BUFFER, corners.size() * sizeof(GLuint), corners.data());
    const std::size_t bytes = sites_.size() * outline.vertices.size() * sizeof(SiteVertex);
    bind_and_fill(kind.sites, GL_ARRAY_BUFFER, bytes, nullptr);
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
    for (const std::uint32_t i : in_clusters().order) {
        part.insert(part.end(), outline.vertices.size(), site_vertex(sites_[i]));
        if (part.size() >= kAtOnce) send();
    }
    send();
    return kind;
}

std::vector<ArrowField::Part> ArrowField::front_to_back(const ArrowDraw& draw, const CameraView& view) {
    const glm::dvec4 depth = glm::row(view.clip_from_world(), 3),
                     behind_near = glm::row(view.clip_from_world(), 2) + depth;
    std::vector<Part> parts;
    for (const SiteCluster& cluster : in_clusters().clusters) {
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
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].always_seen) continue;
        GLuint seen = GL_TRUE;
        glGetQueryObjectuiv(queries_[i].id(), GL_QUERY_RESULT, &seen);
        parts[i].hidden = seen == GL_FALSE;
    }
}

void ArrowField::draw_parts(const Kind& kind, std::span<const Part> parts) {
    // What a software driver bins of several draws adds up, where it draws slower than it bins: gigabytes.
    constexpr std::size_t kAhead = 65'536;
    glBindVertexArray(kind.array.id());
    glBindBuffer(GL_ARRAY_BUFFER, kind.sites.id());
    glDisable(GL_CULL_FACE);
    std::size_t ahead = 0;
    for (const Part& part : parts) {
        if (part.hidden) continue;
        point_at_sites(part.cluster->first * static_cast<std::size_t>(kind.shape_vertices), 0);
        glDrawElements(GL_TRIANGLES, kind.shape_corners * static_cast<GLsizei>(part.cluster->count), GL_UNSIGNED_INT,
                       nullptr);
        ahead += part.cluster->count;
        if (ahead < kAhead) continue;
        wait_for_pixels();
        ahead = 0;
    }
}

void ArrowField::draw(const SceneProgram& program, const ArrowDraw& draw, const CameraView& view) {
    const Kind& kind = this->kind(draw.look);
    std::vector<Part> parts = front_to_back(draw, view);
    if (sites_.size() < kHidingFrom || !answers_at_once()) return draw_parts(kind, parts);
    // The surface and a quarter of its arrows hide nearly all that will be hidden.
    std::size_t nearest = 0;
    for (std::size_t sites = 0; sites < sites_.size() / 4; ++nearest) sites += parts[nearest].cluster->count;
    const std::span<Part> first = std::span(parts).first(nearest), rest = std::span(parts).subspan(nearest);
    draw_parts(kind, first);
    find_hidden(rest, view);
    program.use();
    draw_parts(kind, rest);
}

}  // namespace normalscope

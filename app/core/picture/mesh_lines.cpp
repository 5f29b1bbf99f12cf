#include "core/picture/mesh_lines.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace normalscope {

namespace {

constexpr double kSharp = 0.82;   // the cosine of 35°
constexpr double kTrusted = 0.5;  // that of 60°

class Lines {
public:
    Lines(const SeenMesh& seen, Outline outline) : seen_(seen), outline_(outline) {}

    std::vector<MeshLine> all() {
        along_edges();
        if (outline_ == Outline::ByNormals)
            for (const glm::uvec3& t : seen_.mesh.triangles)
                if (seen_.draws(t)) through(t);
        return std::move(lines_);
    }

private:
    struct Edge {
        glm::dvec3 normal{0.0};  ///< along the first triangle
        int fronts = 0, count = 0;
        bool sharp = false;
        std::size_t a = 0, b = 0;
    };

    glm::dvec3 outward(std::size_t vertex) const {
        const auto n = seen_.m(Point<Object>{seen_.mesh.positions[vertex]}, Normal<Object>{seen_.mesh.normals[vertex]});
        return n && glm::length(n->xyz) > 0.0 ? glm::normalize(n->xyz) : glm::dvec3(0.0);
    }

    // By its corners, twice the triangle's area long. Reflections turn it inward, which M's normals are not.
    glm::dvec3 face_normal(const glm::uvec3& t) const {
        return sense_ * glm::cross(seen_.world[t.y] - seen_.world[t.x], seen_.world[t.z] - seen_.world[t.x]);
    }

    bool is_line(const Edge& edge) const {
        if (edge.count == 1) return true;
        if (outline_ == Outline::ByFaces && edge.fronts > 0 && edge.fronts < edge.count) return true;
        return edge.sharp && (edge.fronts > 0 || !seen_.mesh.closed);
    }

    void along_edges() {
        const Mesh& mesh = seen_.mesh;
        using Key = std::array<std::int64_t, 3>;
        const auto key = [](const glm::dvec3& v) {
            return Key{std::llround(v.x * 1e6), std::llround(v.y * 1e6), std::llround(v.z * 1e6)};
        };
        std::map<std::pair<Key, Key>, Edge> edges;  // by place: a cube's faces have vertices of their own
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            if (!seen_.draws(t)) continue;
            const glm::dvec3 n = face_normal(t);
            if (!(glm::length(n) > 0.0)) continue;
            for (int k = 0; k < 3; ++k) {
                const std::size_t a = t[k], b = t[(k + 1) % 3];
                auto ends = std::pair(key(mesh.positions[a]), key(mesh.positions[b]));
                if (ends.second < ends.first) std::swap(ends.first, ends.second);
                if (ends.first == ends.second) continue;
                Edge& edge = edges[ends];
                const glm::dvec3 side =
                    outline_ == Outline::ByFaces ? glm::normalize(n) : mesh.normals[a] + mesh.normals[b];
                if (edge.count++ == 0)
                    edge.normal = side, edge.a = a, edge.b = b;
                else
                    edge.sharp |= glm::dot(edge.normal, side) < kSharp * glm::length(edge.normal) * glm::length(side);
                edge.fronts += seen_.front[i] ? 1 : 0;
            }
        }
        for (const auto& [ends, edge] : edges)
            if (is_line(edge)) lines_.push_back({{seen_.world[edge.a], seen_.world[edge.b]}, outward(edge.a)});
    }

    // Hertzmann, "Introduction to 3D Silhouette Detection and Rendering" (1999), smooth surfaces: n · (eye − p) between
    // the corners is as good as linear.
    void through(const glm::uvec3& t) {
        const glm::dvec3 face = face_normal(t);
        std::array<double, 3> facing{};
        std::array<glm::dvec3, 3> normals;
        for (int k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(k);
            normals[i] = outward(t[k]);
            // Beside places where ∇f is 0 they may be anything.
            if (!(glm::dot(face, normals[i]) > kTrusted * glm::length(face))) return;
            facing[i] = glm::dot(normals[i], seen_.view.eye().xyz - seen_.world[t[k]]);
        }
        std::vector<glm::dvec3> ends;
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3;
            if ((facing[a] > 0.0) == (facing[b] > 0.0)) continue;
            const auto from = static_cast<glm::length_t>(a), to = static_cast<glm::length_t>(b);
            ends.push_back(glm::mix(seen_.world[t[from]], seen_.world[t[to]], facing[a] / (facing[a] - facing[b])));
        }
        const glm::dvec3 n = normals[0] + normals[1] + normals[2];
        if (ends.size() == 2) lines_.push_back({{ends[0], ends[1]}, glm::normalize(n)});
    }

    const SeenMesh& seen_;
    Outline outline_;
    double sense_ = seen_.m.reflects() ? -1.0 : 1.0;
    std::vector<MeshLine> lines_;
};

}  // namespace

std::vector<MeshLine> mesh_lines(const SeenMesh& seen, Outline outline) { return Lines(seen, outline).all(); }

}  // namespace normalscope

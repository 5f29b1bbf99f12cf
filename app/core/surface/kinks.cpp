#include "core/surface/kinks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace normalscope {

namespace {

constexpr double kTurned = 0.82;         // the cosine of 35°
constexpr double kLikeAnEnd = 0.2;       // of the angle between the ends' normals
constexpr double kWithin = 0.55;         // of an edge, from its middle, and a little more for what is curved
constexpr double kFarthestCorner = 1.0;  // from the triangle's middle, in its longest edges

double angle(const glm::dvec3& a, const glm::dvec3& b) { return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)); }

class Cutter {
public:
    Cutter(Mesh& mesh, const ImplicitSurface& surface) : mesh_(mesh), surface_(surface) {}

    void cut() {
        std::vector<glm::uvec3> kept;
        for (glm::uvec3 t : mesh_.triangles) {
            const auto crossed = [&] {
                return std::array{kink(t.x, t.y) != nullptr, kink(t.y, t.z) != nullptr, kink(t.z, t.x) != nullptr};
            };
            const auto count = std::ranges::count(crossed(), true);
            // The corner that is alone on its side comes first; or the one edge that is crossed.
            while (count == 2 && crossed()[1]) t = {t.y, t.z, t.x};
            while (count == 1 && !crossed()[0]) t = {t.y, t.z, t.x};
            if (count == 0) kept.push_back(t);
            if (count == 1) add(kept, {{t.x, on(t.x, t.y), t.z}, {on(t.y, t.x), t.y, t.z}});
            if (count == 2)
                add(kept,
                    {{t.x, on(t.x, t.y), on(t.x, t.z)}, {on(t.y, t.x), t.y, t.z}, {on(t.y, t.x), t.z, on(t.z, t.x)}});
            if (count == 3) {
                const glm::dvec3 corner = meeting(t);
                for (int k = 0; k < 3; ++k, t = {t.y, t.z, t.x}) {
                    const std::uint32_t own = new_vertex(corner, mesh_.normals[t.x]);
                    add(kept, {{t.x, on(t.x, t.y), own}, {t.x, own, on(t.x, t.z)}});
                }
            }
        }
        mesh_.triangles = std::move(kept);
        mesh_.face_of_triangle.clear();
    }

private:
    static void add(std::vector<glm::uvec3>& all, const std::vector<glm::uvec3>& more) {
        all.insert(all.end(), more.begin(), more.end());
    }
    std::uint32_t new_vertex(const glm::dvec3& p, const glm::dvec3& normal) {
        mesh_.positions.push_back(p);
        mesh_.normals.push_back(normal);
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }

    // Where the kink crosses the edge; null where it does not.
    const glm::dvec3* kink(std::uint32_t a, std::uint32_t b) {
        const auto [known, is_new] = kinks_.try_emplace(std::minmax(a, b));
        if (is_new) known->second = find_kink(known->first.first, known->first.second);
        return known->second ? &*known->second : nullptr;
    }
    std::optional<glm::dvec3> find_kink(std::uint32_t a, std::uint32_t b) const {
        const glm::dvec3 &na = mesh_.normals[a], &nb = mesh_.normals[b];
        const glm::dvec3 from = mesh_.positions[a], way = mesh_.positions[b] - from;
        const double between = angle(na, nb);
        if (!(std::cos(between) < kTurned)) return std::nullopt;
        // What bends has normals between the two on the way; beside a kink each is still that of one side.
        for (const double part : {0.25, 0.5, 0.75}) {
            const glm::dvec3 gradient = surface_.at({from + part * way}).gradient;
            if (!(glm::length(gradient) > 0.0)) return std::nullopt;
            const glm::dvec3 n = glm::normalize(gradient);
            if (std::min(angle(n, na), angle(n, nb)) > kLikeAnEnd * between) return std::nullopt;
        }
        // The two tangent planes meet above the edge, at from + s way + h up.
        const glm::dvec3 up = na + nb - glm::dot(na + nb, way) / glm::dot(way, way) * way;
        const glm::dmat2 rows(glm::dot(na, way), glm::dot(nb, way), glm::dot(na, up), glm::dot(nb, up));
        const glm::dvec2 at = glm::inverse(rows) * glm::dvec2(0.0, glm::dot(nb, way));
        // Beside places where ∇f is 0 normals may be anything, and belong to no planes that meet there.
        if (!(std::abs(at.x - 0.5) < kWithin)) return std::nullopt;
        return from + at.x * way + at.y * up;
    }

    // The kink's vertex between a and b, on a's side.
    std::uint32_t on(std::uint32_t a, std::uint32_t b) {
        const auto [known, is_new] = vertices_.try_emplace({a, b});
        if (is_new) known->second = new_vertex(*kink(a, b), mesh_.normals[a]);
        return known->second;
    }

    // Of the three tangent planes; the triangle's middle where they do not meet nearby.
    glm::dvec3 meeting(const glm::uvec3& t) const {
        const std::array corners{mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z]};
        const std::array normals{mesh_.normals[t.x], mesh_.normals[t.y], mesh_.normals[t.z]};
        const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        const double size = std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                                      glm::distance(corners[2], corners[0])});
        glm::dvec3 offsets;
        for (glm::length_t i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            offsets[i] = glm::dot(normals[k], corners[k] - middle);
        }
        const glm::dvec3 p = glm::inverse(glm::transpose(glm::dmat3(normals[0], normals[1], normals[2]))) * offsets;
        return glm::length(p) < kFarthestCorner * size ? middle + p : middle;
    }

    Mesh& mesh_;
    const ImplicitSurface& surface_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::optional<glm::dvec3>> kinks_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> vertices_;
};

}  // namespace

Mesh cut_at_kinks(Mesh mesh, const ImplicitSurface& surface) {
    Cutter(mesh, surface).cut();
    return mesh;
}

}  // namespace normalscope

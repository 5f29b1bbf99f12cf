#include "core/picture/decomposition_marks.h"

#include "core/base/decimal.h"
#include "core/frame/arcs.h"
#include "core/frame/frame_options.h"
#include "core/frame/solids.h"
#include "core/math/polar_decomposition.h"
#include "core/scene/mistakes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

constexpr double kBeyondUnitBall = 1.2;  // so that the ends come out of the object

// The vertex whose normal comes nearest to one of the two that are worst.
std::size_t nearest_normal(const Mesh& mesh, const WorstNormal& worst) {
    std::size_t best = 0;
    double best_cosine = -2.0;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const double cosine =
            std::max(glm::dot(mesh.normals[i], worst.object[0].xyz), glm::dot(mesh.normals[i], worst.object[1].xyz));
        if (cosine > best_cosine) best_cosine = cosine, best = i;
    }
    return best;
}

/// Arrows with words at their ends.
class Marks {
public:
    Marks(Pane& pane, const glm::vec3& ink) : pane_(pane), ink_(ink) {}

    void arrow(const glm::dvec3& base, const glm::dvec3& vector, double radius, const glm::vec3& color,
               ArrowLook look = ArrowLook::Plain) {
        add_arrow(pane_.solids, base, vector, radius, glm::vec4(color, 1.0f), look, {});
        pane_.strokes.push_back({base, base + vector, ArrowProportions::kHeadRadius * radius});
    }
    void name(const glm::dvec3& at, std::string text) { pane_.wanted.push_back({at, std::move(text), ink_}); }

private:
    Pane& pane_;
    glm::vec3 ink_;
};

}  // namespace

void add_decomposition_marks(Pane& pane, const Scene& scene, const Mesh& mesh, const Transform<World, Object>& any,
                             const FrameOptions& options) {
    // Of an M that is not affine: what it does next to the middle.
    const Transform<World, Object> world_from_object = any.at({});
    const NormalMatrices& matrices = world_from_object.normal_matrices_by_rule();
    const Decomposition parts = decomposition(matrices.naive, matrices.rank);
    const glm::dvec3 origin = world_from_object(Point<Object>{}).xyz;
    const double pixel = options.pixel_scale * pane.view.world_per_pixel({origin});
    const glm::vec3 ink = theme_colors(scene.theme).text;
    Marks marks(pane, ink);
    for (std::size_t i = 0; i < parts.axes.size(); ++i) {
        const StretchAxis& axis = parts.axes[i];
        const glm::dvec3 end = (kBeyondUnitBall * axis.factor) * axis.to.xyz;
        const double radius = std::max(0.012 * options.unit, 1.6 * pixel);
        marks.arrow(origin, end, radius, ink);
        marks.arrow(origin, -end, radius, ink);
        marks.name(origin + end,
                   std::array{"\u03C3\u2081 ", "\u03C3\u2082 ", "\u03C3\u2083 "}[i] + with_decimals(axis.factor, 2));
    }

    const std::optional<WorstNormal> worst = worst_normal(matrices, shown_power(scene));
    if (!any.affine() || !worst || worst->degrees < 1e-6 || mesh.normals.empty()) return;
    const std::size_t vertex = nearest_normal(mesh, *worst);
    const Normal<Object> n{mesh.normals[vertex]};
    const auto right = world_from_object(n);
    const Normal<World> naive{*between_the_rules(matrices, shown_power(scene)) * n.xyz};
    if (!right || !angle_degrees(naive.xyz, right->xyz)) return;
    const glm::dvec3 base = world_from_object(Point<Object>{mesh.positions[vertex]}).xyz;
    const glm::dvec3 u = glm::normalize(naive.xyz), v = glm::normalize(right->xyz);
    const double length = std::max(4.6 * options.unit * scene.arrows.length, 70.0 * pixel),
                 radius = std::max(0.022 * length, 1.7 * pixel);
    marks.arrow(base, length * u, radius, kNaiveColor, ArrowLook::Dashed);
    marks.arrow(base, length * v, radius, kInverseTransposeColor);
    const std::vector<glm::dvec3> arc = arc_between(base, u, v, 0.6 * length);
    add_tube(pane.solids, arc, std::max(0.007 * options.unit, 1.1 * pixel), glm::vec4(ink, 1.0f));
    keep_clear(pane, arc);
    marks.name(arc[arc.size() / 2], "worst " + with_decimals(*angle_degrees(u, v), 1) + "\u00B0");
}

}  // namespace normalscope

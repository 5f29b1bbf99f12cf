#include "core/picture/decomposition_marks.h"

#include "core/base/decimal.h"
#include "core/math/polar_decomposition.h"
#include "core/picture/arcs.h"
#include "core/picture/frame_options.h"
#include "core/picture/solids.h"
#include "core/scene/mistakes.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace normalscope {

namespace {

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

void add_label(Pane& pane, const glm::dvec3& at, const std::string& text, const glm::vec3& color) {
    const glm::dvec3 pixel = pane.view.pixel({at});
    if (pixel.z > 0.0)
        pane.labels.push_back({Label::Role::Axis, glm::vec2(pane.rect.origin) + glm::vec2(pixel), text, color});
}

}  // namespace

void add_decomposition_marks(Pane& pane, const Scene& scene, const Mesh& mesh, const Transform<World, Object>& any,
                             const FrameOptions& options) {
    // Of an M that is not affine: what it does next to the middle.
    const Transform<World, Object> world_from_object = any.at({});
    const NormalMatrices& matrices = world_from_object.normal_matrices_by_rule();
    const Decomposition parts = decomposition(matrices.naive, matrices.rank);
    const glm::dvec3 origin = world_from_object(Point<Object>{}).xyz;
    const double pixel = options.pixel_scale * pane.view.world_per_pixel({origin});
    const glm::vec4 ink(theme_colors(scene.theme).text, 1.0f);
    for (std::size_t i = 0; i < parts.axes.size(); ++i) {
        const StretchAxis& axis = parts.axes[i];
        // A little longer than the unit ball's image, so that the ends come out of the object.
        const glm::dvec3 end = (1.2 * axis.factor) * axis.to.xyz;
        const double radius = std::max(0.012 * options.unit, 1.6 * pixel);
        add_arrow(pane.solids, origin, end, radius, ink);
        add_arrow(pane.solids, origin, -end, radius, ink);
        const std::string text =
            std::array{"\u03C3\u2081 ", "\u03C3\u2082 ", "\u03C3\u2083 "}[i] + with_decimals(axis.factor, 2);
        add_label(pane, origin + 1.08 * end, text, theme_colors(scene.theme).text);
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
    add_arrow(pane.solids, base, length * u, radius, glm::vec4(kNaiveColor, 1.0f), ArrowLook::Dashed, {});
    add_arrow(pane.solids, base, length * v, radius, glm::vec4(kInverseTransposeColor, 1.0f));
    const std::vector<glm::dvec3> arc = arc_between(base, u, v, 0.6 * length);
    add_tube(pane.solids, arc, std::max(0.007 * options.unit, 1.1 * pixel), ink);
    const std::string text = "worst " + with_decimals(*angle_degrees(u, v), 1) + "\u00B0";
    add_label(pane, base + 1.5 * (arc[arc.size() / 2] - base), text, theme_colors(scene.theme).text);
}

}  // namespace normalscope

#include "core/explain/explanation.h"

#include "core/picture/make_frame.h"
#include "core/scene/mistakes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

// What the scene has in the naive rule's place, if not that rule itself.
std::string note_on(const Scene& scene, const Transform<World, Object>& m, const std::optional<Probe>& probe) {
    const InNaivePlace shown = in_naive_place(scene);
    std::string note = "In the naive rule's place the picture shows " +
                       std::string(scene.mistake == Mistake::Naive ? "" : "another mistake, ") + shown.formula + " (" +
                       shown.title + "). " + shown.reason;
    const std::optional<NormalMap> map = normal_map(scene, m, Rule::Naive);
    const std::optional<Normal<World>> right = probe ? m(probe->point, probe->normal) : std::nullopt;
    if (!map || !right) return note;
    const auto off = angle_degrees((*map)(probe->normal).xyz, right->xyz);
    return off ? note + " At the probe its direction is off by " + number_text(*off, 1e-7, 3) + "°." : note;
}

}  // namespace

std::vector<std::string> notes(const Scene& scene, const Transform<World, Object>& m,
                               const std::optional<Probe>& probe) {
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const std::vector<StackEntry> stack = applied_stack(scene);
    std::vector<std::string> result;
    if (stack.empty()) result.emplace_back("The stack is empty: M is the identity, and every rule agrees.");
    if (std::ranges::any_of(stack, [](const StackEntry& entry) {
            const auto* given = std::get_if<Matrix>(&entry);
            return given && given->matrix != matrix(entry);
        }))
        result.emplace_back(
            "A matrix whose bottom row is 0 0 0 s, up to rounding, is the same map as that matrix divided by s, since "
            "points are divided by their w. It is shown that way.");
    if (!m.affine())
        result.emplace_back(
            "M is not affine: its bottom row is not 0 0 0 1. Points are divided by their w, tangents are sent through "
            "the Jacobian (M₃ − p′ rᵀ)/w at their point, and normals follow their tangent planes, which are sent "
            "through (M⁻¹)ᵀ: no 3×3 matrix does that everywhere. Every rule, made from the upper left 3×3, M₃, is an "
            "approximation here, and statements about M₃ are about M₃ alone.");
    if (!m.affine() && m.rank() < 3)
        result.emplace_back(
            "M has no inverse: it flattens every solid, and there is no (M⁻¹)ᵀ to send planes through.");
    if (!plainly_naive(scene)) result.push_back(note_on(scene, m, probe));
    if (m.affine() && matrices.rank == 2)
        result.emplace_back(
            "M₃ has rank 2: it flattens the object to a plane. It has no inverse, so there is no inverse transpose; "
            "the "
            "cofactor matrix still gives the flattened object's normal.");
    if (m.affine() && matrices.rank == 1)
        result.emplace_back(
            "M₃ has rank 1: it flattens the object to a line. There is no inverse, the cofactor matrix is zero, and "
            "there is no normal at all.");
    if (m.affine() && matrices.rank == 0)
        result.emplace_back("M₃ is zero: the object shrinks to a point. No rule gives a normal.");
    if (m.affine() && matrices.determinant < 0.0)
        result.emplace_back(
            "M₃ reflects (its determinant is negative). The inverse transpose carries gradients, so its normal keeps "
            "pointing "
            "outward; the cofactor follows the triangles' winding, which the reflection has reversed, so its normal is "
            "the opposite one. Each is right for its own question.");
    if (const auto k = matrices.condition(); k && *k > 1e4) {
        const int lost = static_cast<int>(std::lround(std::log10(*k)));
        result.push_back("M₃ is nearly singular: its condition number is " + number_text(*k, 0.0, 3) +
                         ", so the inverse may lose about " + std::to_string(lost) + " of a double's 16 digits" +
                         (lost >= 12 ? "; treat it as if it had no inverse." : "."));
    }
    if (m.affine() && matrices.rank < 3 && singular_values(matrices.naive).sigma.z > 0.0)
        result.emplace_back(
            "The smallest stretch factor is no larger than what rounding makes of zero (4ε of the largest), or an "
            "entry of the "
            "stack is singular: it counts as zero.");
    if (std::holds_alternative<FormulaSurface>(scene.surface) && !m.affine())
        result.emplace_back(
            "Rays bend under an M that is not affine: the picture shows the surface’s triangles, carried along by M.");
    else if (std::holds_alternative<FormulaSurface>(scene.surface) && matrices.rank < 3)
        result.emplace_back(
            "Without M⁻¹ no ray can be taken to object space: the picture shows the surface's triangles, carried "
            "along "
            "by M.");
    if (probe && probe->borrowed_from)
        result.push_back(
            "At the probe ∇f is zero or does not exist: there is no normal. What follows borrows that of a neighbour "
            "on the surface, " +
            number_text(glm::distance(probe->borrowed_from->xyz, probe->point.xyz), 0.0, 3) + " away.");
    if (probe && !probe->has_normal())
        result.emplace_back(
            "At the probe ∇f is zero or does not exist: there is no normal, and the derivation has no numbers. A cheap "
            "remedy is to borrow a neighbour's: set borrow.azimuth.");
    if (!probe)
        result.push_back(
            "The camera sees nothing of the surface" +
            std::string(std::holds_alternative<FormulaSurface>(scene.surface) ? " that has a normal" : "") +
            ", so there is no probe, and the derivation has no numbers.");
    return result;
}

std::string_view name(ExplainFormat format) {
    constexpr std::array<std::string_view, 3> kNames{"text", "json", "latex"};
    return kNames.at(static_cast<std::size_t>(format));
}

Explanation explanation(const Scene& scene, const std::optional<Probe>& any_probe, std::size_t tangent) {
    const std::optional<Probe> probe = with_normal(any_probe);
    const Transform<World, Object> m = world_from_object(scene);
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const std::vector<StackEntry> stack = applied_stack(scene);
    const int factors = static_cast<int>(stack.size());
    Explanation e;
    e.about = scene.about;
    e.m = value_of(m.matrix(), factors);
    e.affine = m.affine();
    e.matrices = matrices;
    e.probe = probe;
    e.notes = notes(scene, m, any_probe);
    e.derivation = derivation(m, factors, probe, tangent);
    e.stack = stack_algebra(stack);
    if (!stack.empty()) e.orders = orders_of_inverses(stack, m, probe);
    e.decomposition = decomposition(matrices.naive, matrices.rank);
    if (!m.affine()) e.decomposition.worst.reset();  // of M3 alone
    e.claims = claims(m.matrix(), matrices.rank);
    e.classes = map_classes(m.matrix(), matrices.rank);
    return e;
}

std::string explain(const Scene& scene, ExplainFormat format) {
    SurfaceCache surfaces;
    const Frame frame = make_frame(scene, surfaces.get(scene), {.rect = {{0, 0}, {1280, 720}}});
    Explanation e = explanation(scene, frame.probe ? std::optional(frame.probe->object) : std::nullopt);
    e.implicit = frame.surface->implicit;
    if (frame.probe) e.gradient = gradient_report(*frame.surface, frame.probe->object);
    const std::vector<std::string>& notes = frame.surface->mesh.notes;
    if (e.implicit) e.notes.insert(e.notes.end(), notes.begin(), notes.end());
    switch (format) {
        case ExplainFormat::Text: return explanation_text(e);
        case ExplainFormat::Json: return explanation_json(scene, frame, e);
        case ExplainFormat::Latex: return explanation_latex(e);
        case ExplainFormat::LatexFragment: return equations_latex(e);
    }
    return {};
}

}  // namespace normalscope

#include "core/scene/mistakes.h"

#include "core/base/decimal.h"

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

// Each column divided by the square of its length: the inverse transpose of a rotation after a scale, but of no shear.
glm::dmat3 divided_by_scale_squared(const glm::dmat3& m3) {
    glm::dmat3 result = m3;
    for (int c = 0; c < 3; ++c)
        if (const double length2 = glm::dot(m3[c], m3[c]); length2 > 0.0) result[c] /= length2;
    return result;
}

// (M⁻¹)ᵀ as a 4×4 matrix: its bottom row, −(M3⁻¹ t)ᵀ, puts the translation into w.
glm::dmat4 inverse_transpose_4x4(const glm::dmat3& inverse_transpose, const glm::dvec3& translation) {
    glm::dmat4 result(inverse_transpose);
    const glm::dvec3 back = glm::transpose(inverse_transpose) * translation;
    for (int c = 0; c < 3; ++c) result[c].w = -back[c];
    return result;
}

std::optional<NormalMap> mistaken_map(const Scene& scene, const Transform<World, Object>& m) {
    const NormalMatrices& matrices = m.normal_matrices_by_rule();
    const auto linear = [](const std::optional<glm::dmat3>& n) {
        return n ? std::optional(NormalMap{.matrix = glm::dmat4(*n)}) : std::nullopt;
    };
    switch (scene.mistake) {
        case Mistake::Naive: return linear(between_the_rules(matrices, scene.power));
        case Mistake::ModelView:
        case Mistake::ZeroNormal: return linear(matrices.naive);
        case Mistake::InversesNotReversed:
            return linear(reversed_composite_of_inverse_transposes(applied_stack(scene)));
        case Mistake::NotTransposed:
            return linear(matrices.inverse_transpose ? std::optional(glm::transpose(*matrices.inverse_transpose))
                                                     : std::nullopt);
        case Mistake::NotInverted: return linear(glm::transpose(matrices.naive));
        case Mistake::WOne: return NormalMap{.matrix = m.matrix(), .w = 1.0};
        case Mistake::DivideByScaleSquared: return linear(divided_by_scale_squared(matrices.naive));
        case Mistake::TangentsByInverseTranspose:
        case Mistake::TangentsByCofactor: return linear(matrices.inverse_transpose);
        case Mistake::LeakingTranslation:
            if (!matrices.inverse_transpose) return std::nullopt;
            return NormalMap{.matrix = inverse_transpose_4x4(*matrices.inverse_transpose, glm::dvec3(m.matrix()[3])),
                             .at_vertices = NormalMap::UnitLength::WithW,
                             .at_pixels = false};
        case Mistake::NoRenormalisation:
            if (!matrices.inverse_transpose) return std::nullopt;
            return NormalMap{.matrix = glm::dmat4(*matrices.inverse_transpose), .at_pixels = false};
    }
    return std::nullopt;
}

}  // namespace

std::optional<NormalMap> normal_map(const Scene& scene, const Transform<World, Object>& world_from_object, Rule rule,
                                    double right_power) {
    const NormalMatrices& matrices = world_from_object.normal_matrices_by_rule();
    std::optional<NormalMap> map;
    if (rule == Rule::Naive)
        map = mistaken_map(scene, world_from_object);
    else if (const auto n = rule == Rule::InverseTranspose && matrices.rank == 3
                                ? between_the_rules(matrices, right_power)
                                : matrices.by(rule);
             n && (rule != Rule::Cofactor || matrices.rank >= 2))
        map = NormalMap{.matrix = glm::dmat4(*n)};
    if (map && map->at_pixels && !scene.renormalise) {
        map->at_pixels = false;
        map->at_vertices = NormalMap::UnitLength::WithoutW;
    }
    return map;
}

std::optional<glm::dmat3> mistaken_tangents(const Scene& scene, const Transform<World, Object>& world_from_object) {
    const NormalMatrices& matrices = world_from_object.normal_matrices_by_rule();
    if (scene.rule != Rule::Naive) return std::nullopt;
    if (scene.mistake == Mistake::TangentsByInverseTranspose) return matrices.inverse_transpose;
    if (scene.mistake == Mistake::TangentsByCofactor) return matrices.cofactor;
    return std::nullopt;
}

MistakeText text(Mistake mistake) {
    switch (mistake) {
        case Mistake::Naive:
            return {"naive", "M n",
                    "A normal does not lead from one point to another: what it must keep is its right angle to the "
                    "surface."};
        case Mistake::InversesNotReversed:
            return {"inverses not reversed", "(A⁻¹B⁻¹)ᵀ n", "(AB)⁻¹ is B⁻¹A⁻¹: inverting reverses the order."};
        case Mistake::NotTransposed: return {"not transposed", "M⁻¹ n", "The inverse alone goes back to object space."};
        case Mistake::NotInverted:
            return {"not inverted", "Mᵀ n", "The transpose alone undoes rotations and keeps the scales."};
        case Mistake::WOne:
            return {"w = 1", "M (n, 1)",
                    "A normal sent as a point takes the translation along: the farther the object moves, the more "
                    "alike all normals become."};
        case Mistake::LeakingTranslation:
            return {"translation in w", "(M⁻¹)ᵀ (n, 0)",
                    "The 4×4 inverse transpose writes the translation into w; normalised with it, the normal is too "
                    "short and the light too dim."};
        case Mistake::ModelView:
            return {
                "mat3(modelView)", "mat3(V M) n",
                "The view only rotates, so this is the naive rule in disguise: right until someone scales unevenly."};
        case Mistake::DivideByScaleSquared:
            return {"divided by scale²", "M n / s²",
                    "Dividing each column by its squared length inverts a scale, even one that a rotation follows. A "
                    "shear breaks it."};
        case Mistake::NoRenormalisation:
            return {"not renormalised", "(M⁻¹)ᵀ n, as long as it is",
                    "The direction is right, the length is not: light comes out too bright or too dim."};
        case Mistake::ZeroNormal:
            return {"zero normal", "M n / |M n|",
                    "Flattened, some normals become zero; divided by their length they become NaN, which shows as "
                    "black spots."};
        case Mistake::TangentsByInverseTranspose:
            return {"tangents by (M⁻¹)ᵀ", "(M⁻¹)ᵀ v",
                    "Tangents join points of the surface: unless they are sent through M, they leave it."};
        case Mistake::TangentsByCofactor:
            return {"tangents by cof(M)", "cof(M) v",
                    "The cofactor is for surface elements, two tangents at once; a single one is sent through M."};
    }
    return {};
}

InNaivePlace in_naive_place(const Scene& scene) {
    const MistakeText mistake = text(scene.mistake);
    const double p = shown_power(scene);
    if (p == 1.0) return {std::string(mistake.title), std::string(mistake.formula), std::string(mistake.reason)};
    const std::string reason =
        "M₃ = R S is a stretch S, then a rotation R. With the stretch to the power p, R Sᵖ is the naive rule at p = 1, "
        "the rotation alone at 0, and the inverse transpose at −1.";
    if (p == 0.0) return {"rotation only", "R n", reason};
    const std::string number = (p < 0.0 ? "−" : "") + with_decimals(std::abs(p), 2);
    return {"p = " + number, p == -1.0 ? "R S⁻¹ n" : "R Sᵖ n", reason};
}

std::string normal_formula(Rule rule, const Scene& scene) {
    if (rule != Rule::Naive) return std::string(formula(rule));
    if (about_tangents(scene.mistake) || scene.mistake == Mistake::NoRenormalisation)
        return std::string(formula(Rule::InverseTranspose));
    return in_naive_place(scene).formula;
}

}  // namespace normalscope

#pragma once

#include "core/math/normal_rules.h"
#include "core/math/projective.h"
#include "core/math/space.h"

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <optional>

namespace normalscope {

/// A map named destination first: `Transform<World, Object> world_from_object`. The kind of the argument decides how it is
/// transformed, so that a normal cannot go through M by accident. Mostly it is affine; where it is not, what it does to
/// tangents and normals depends on the place.
template <class To, class From>
class Transform {
public:
    Transform() = default;
    /// `known_rank` as in normal_matrices.
    explicit Transform(const glm::dmat4& to_from_from, std::optional<int> known_rank = {})
        : matrix_(with_unit_w(to_from_from)),
          normals_(normal_matrices(glm::dmat3(matrix_), known_rank)),
          affine_(is_affine(matrix_)) {
        if (!affine_) planes_ = planes_by(matrix_);
    }

    /// Whether the bottom row is 0 0 0 1, so that M is a linear map and a translation.
    bool affine() const { return affine_; }

    /// M p, with w = 1, divided by the resulting w where M is not affine.
    Point<To> operator()(Point<From> p) const {
        const glm::dvec4 h = matrix_ * glm::dvec4(p.xyz, 1.0);
        return {h.w == 1.0 || h.w == 0.0 ? glm::dvec3(h) : glm::dvec3(h) / h.w};
    }
    /// Whether p has an image: what an M that is not affine sends to infinity or beyond it (w ≤ 0) has none.
    bool reaches(Point<From> p) const { return affine_ || w(p) > 0.0; }
    /// What p's image is divided by: 1 where M is affine.
    double w(Point<From> p) const { return affine_ ? 1.0 : glm::dot(bottom_row(), p.xyz) + matrix_[3].w; }

    /// M3 v: with w = 0 the translation drops out. Right where M is affine.
    Vector<To> operator()(Vector<From> v) const { return {normals_.naive * v.xyz}; }
    /// (M3⁻¹)ᵀ n, as a gradient transforms; empty where M3 has no inverse. Not normalised. Right where M is affine.
    std::optional<Normal<To>> operator()(Normal<From> n) const {
        if (!normals_.inverse_transpose) return std::nullopt;
        return Normal<To>{*normals_.inverse_transpose * n.xyz};
    }

    /// A tangent at p: by the Jacobian (M3 − p′ rᵀ)/w, with p′ the image of p and (rᵀ, s) the bottom row, w = r·p + s.
    Vector<To> operator()(Point<From> p, Vector<From> v) const {
        return affine_ ? (*this)(v)
                       : Vector<To>{(normals_.naive * v.xyz - glm::dot(bottom_row(), v.xyz) * (*this)(p).xyz) / w(p)};
    }
    /// The normal at p: by the image of its tangent plane π = (n, −n·p), which is (M⁻¹)ᵀ π, as the inverse transpose of the
    /// Jacobian would, w (M⁻¹)ᵀ π. Empty where M has no inverse, and where p has no image. Not normalised.
    std::optional<Normal<To>> operator()(Point<From> p, Normal<From> n) const {
        if (affine_) return (*this)(n);
        if (!planes_ || !reaches(p)) return std::nullopt;
        return Normal<To>{w(p) * glm::dvec3(*planes_ * glm::dvec4(n.xyz, -glm::dot(n.xyz, p.xyz)))};
    }
    /// The affine map that M is next to p, with the Jacobian as its 3×3 part; M itself where it is affine. Everything next
    /// to a point that has no image is sent to one point.
    Transform at(Point<From> p) const {
        if (affine_) return *this;
        const int rank = reaches(p) ? rank_of(matrix_) - 1 : 0;
        const glm::dvec3 image = (*this)(p).xyz;
        const glm::dmat3 jacobian =
            rank > 0 ? (normals_.naive - glm::outerProduct(image, bottom_row())) / w(p) : glm::dmat3(0.0);
        glm::dmat4 m(jacobian);
        m[3] = glm::dvec4(image - jacobian * p.xyz, 1.0);
        return Transform(m, rank);
    }

    const glm::dmat4& matrix() const { return matrix_; }
    /// (M⁻¹)ᵀ, which takes planes along; empty where M is affine, as M3 tells all then, and where it has no inverse.
    const std::optional<glm::dmat4>& planes() const { return planes_; }
    /// What the rules are made of: M3, and what follows from it.
    const NormalMatrices& normal_matrices_by_rule() const { return normals_; }
    /// How many dimensions of the object are left: the rank of M3 or, where M is not affine, of its Jacobians.
    int rank() const { return affine_ ? normals_.rank : rank_of(matrix_) - 1; }
    /// Whether it turns windings over. A Jacobian's determinant is det(M)/w⁴.
    bool reflects() const { return (affine_ ? normals_.determinant : glm::determinant(matrix_)) < 0.0; }

    /// The transform back; empty where M has no inverse.
    std::optional<Transform<From, To>> inverse() const {
        if (!affine_) return planes_ ? std::optional(Transform<From, To>(glm::transpose(*planes_))) : std::nullopt;
        if (!normals_.inverse_transpose) return std::nullopt;
        const glm::dmat3 back = glm::transpose(*normals_.inverse_transpose);
        glm::dmat4 inverse(back);
        inverse[3] = glm::dvec4(-(back * glm::dvec3(matrix_[3])), 1.0);
        return Transform<From, To>(inverse, 3);
    }

private:
    glm::dvec3 bottom_row() const { return {matrix_[0].w, matrix_[1].w, matrix_[2].w}; }

    glm::dmat4 matrix_{1.0};
    NormalMatrices normals_ = normal_matrices(glm::dmat3(1.0));
    bool affine_ = true;
    std::optional<glm::dmat4> planes_;
};

/// First `inner`, then `outer`: the spaces in the middle must agree.
template <class To, class Mid, class From>
Transform<To, From> operator*(const Transform<To, Mid>& outer, const Transform<Mid, From>& inner) {
    // Of the M3 of a product that is not affine, those of its factors tell nothing.
    const bool affine = outer.affine() && inner.affine();
    return Transform<To, From>(
        outer.matrix() * inner.matrix(),
        affine ? std::optional(std::min(outer.normal_matrices_by_rule().rank, inner.normal_matrices_by_rule().rank))
               : std::nullopt);
}

/// The naive rule M3 n, which treats a normal as a vector. Right for rigid maps only; here to be looked at.
template <class To, class From>
Normal<To> transform_normal_naively(const Transform<To, From>& m, Normal<From> n) {
    return {m.normal_matrices_by_rule().naive * n.xyz};
}

/// cof(M3) n: follows the triangle's winding and exists for every M; zero where rank M3 < 2.
template <class To, class From>
Normal<To> transform_normal_by_cofactor(const Transform<To, From>& m, Normal<From> n) {
    return {m.normal_matrices_by_rule().cofactor * n.xyz};
}

/// The normal by `rule`, not normalised; empty where the rule gives nothing.
template <class To, class From>
std::optional<Normal<To>> transform_normal(const Transform<To, From>& m, Normal<From> n, Rule rule) {
    switch (rule) {
        case Rule::Naive: return transform_normal_naively(m, n);
        case Rule::InverseTranspose: return m(n);
        case Rule::Cofactor: return transform_normal_by_cofactor(m, n);
    }
    return std::nullopt;
}

}  // namespace normalscope

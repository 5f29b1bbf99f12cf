#pragma once

#include "core/math/normal_rules.h"
#include "core/math/space.h"

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace normalscope {

/// Whether the bottom row is 0 0 0 1, so that M is a linear map and a translation.
inline bool is_affine(const glm::dmat4& m) {
    return m[0].w == 0.0 && m[1].w == 0.0 && m[2].w == 0.0 && std::abs(m[3].w - 1.0) <= 1e-12;
}

/// An affine map named destination first: `Transform<World, Object> world_from_object`. The kind of the argument decides
/// how it is transformed, so that a normal cannot go through M by accident.
template <class To, class From>
class Transform {
public:
    Transform() = default;
    /// `rank_at_most` as in normal_matrices.
    explicit Transform(const glm::dmat4& to_from_from, int rank_at_most = 3)
        : matrix_(to_from_from), normals_(normal_matrices(glm::dmat3(to_from_from), rank_at_most)) {}

    /// M p, with w = 1, divided by the resulting w where M is not affine.
    Point<To> operator()(Point<From> p) const {
        const glm::dvec4 h = matrix_ * glm::dvec4(p.xyz, 1.0);
        return {h.w == 1.0 || h.w == 0.0 ? glm::dvec3(h) : glm::dvec3(h) / h.w};
    }
    /// M3 v: with w = 0 the translation drops out.
    Vector<To> operator()(Vector<From> v) const { return {normals_.naive * v.xyz}; }
    /// (M3⁻¹)ᵀ n, as a gradient transforms; empty where M3 has no inverse. Not normalised.
    std::optional<Normal<To>> operator()(Normal<From> n) const {
        if (!normals_.inverse_transpose) return std::nullopt;
        return Normal<To>{*normals_.inverse_transpose * n.xyz};
    }

    const glm::dmat4& matrix() const { return matrix_; }
    const NormalMatrices& normal_matrices_by_rule() const { return normals_; }

    /// The transform back; empty where M has no inverse.
    std::optional<Transform<From, To>> inverse() const {
        if (!normals_.inverse_transpose || glm::determinant(matrix_) == 0.0) return std::nullopt;
        return Transform<From, To>(glm::inverse(matrix_));
    }

private:
    glm::dmat4 matrix_{1.0};
    NormalMatrices normals_ = normal_matrices(glm::dmat3(1.0));
};

/// First `inner`, then `outer`: the spaces in the middle must agree.
template <class To, class Mid, class From>
Transform<To, From> operator*(const Transform<To, Mid>& outer, const Transform<Mid, From>& inner) {
    return Transform<To, From>(outer.matrix() * inner.matrix(),
                               std::min(outer.normal_matrices_by_rule().rank, inner.normal_matrices_by_rule().rank));
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

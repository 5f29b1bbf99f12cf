#pragma once

#include "core/math/normal_rules.h"
#include "core/math/space.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace normalscope {

/// A direction that M3 only stretches (and then turns): v in object space goes to factor · u in world space.
struct StretchAxis {
    Vector<Object> from;
    Vector<World> to;
    double factor = 1.0;
    bool unique = true;  ///< false where another axis has the same factor: any direction between the two would do
};

/// The normals that the naive rule treats worst, or U Σᵖ Vᵀ in its place (between_the_rules).
struct WorstNormal {
    std::array<Normal<Object>, 2>
        object;  ///< between the axes of the largest and the smallest factor, either side: halfway for M3
    std::array<Normal<World>, 2> naive, right;  ///< of unit length
    double degrees = 0.0;                       ///< between them: the closed form, error_bound_degrees
};

/// M3 = R S: first the stretch S along three perpendicular axes, then the rotation R, which may also reflect. The right
/// polar decomposition, from M3 = U Σ Vᵀ: R = U Vᵀ, S = V Σ Vᵀ (Higham, Functions of Matrices, chapter 8). Only S hurts
/// normals: R is its own inverse transpose.
struct Decomposition {
    glm::dmat3 rotation{1.0};        ///< R: orthogonal, determinant +1, or −1 where M3 reflects
    glm::dmat3 stretch{1.0};         ///< S: symmetric, no negative eigenvalue
    bool reflects = false;           ///< R is a rotation after a mirror image in the plane perpendicular to `axis`
    glm::dvec3 axis{0.0, 0.0, 1.0};  ///< of the rotation; a unit vector
    double degrees = 0.0;            ///< of the rotation, 0 … 180 about `axis`
    bool unique =
        true;  ///< false where M3 has no inverse: then other rotations do as well, and this is one without reflection
    std::array<StretchAxis, 3> axes;   ///< the largest factor first
    std::optional<WorstNormal> worst;  ///< empty where M3 has no inverse
};

/// `known_rank` as in normal_matrices.
Decomposition decomposition(const glm::dmat3& m3, std::optional<int> known_rank = {});

/// Empty where M3 has no inverse.
std::optional<WorstNormal> worst_normal(const NormalMatrices& matrices, double power);

}  // namespace normalscope

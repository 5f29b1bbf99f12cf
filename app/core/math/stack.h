#pragma once

#include "core/math/transform.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace normalscope {

struct Scale {
    glm::dvec3 factors{1.0};
    friend bool operator==(const Scale&, const Scale&) = default;
};
struct Rotate {
    glm::dvec3 axis{0.0, 0.0, 1.0};  ///< any length but zero
    double degrees = 0.0;            ///< counterclockwise, looking against the axis
    friend bool operator==(const Rotate&, const Rotate&) = default;
};
struct Translate {
    glm::dvec3 offset{0.0};
    friend bool operator==(const Translate&, const Translate&) = default;
};
/// Each coordinate slides along the others: x' = x + xy·y + xz·z, and so on.
struct Shear {
    double xy = 0.0, xz = 0.0, yx = 0.0, yz = 0.0, zx = 0.0, zy = 0.0;
    friend bool operator==(const Shear&, const Shear&) = default;
};
struct Matrix {
    glm::dmat4 matrix{1.0};
    friend bool operator==(const Matrix&, const Matrix&) = default;
};

using StackEntry = std::variant<Scale, Rotate, Translate, Shear, Matrix>;

/// "scale", "rotate", "translate", "shear" or "matrix".
std::string_view name(const StackEntry& entry);
/// Part of the entry's way from doing nothing (0) to all that it does (1): angles, offsets and factors grow evenly.
StackEntry partly(const StackEntry& entry, double part);
/// The entry's 4×4 matrix; one with the bottom row 0 0 0 s is divided by s, which is the same map.
glm::dmat4 matrix(const StackEntry& entry);
/// Of the entry's 3×3 part: numerical of a matrix, as in NormalMatrices; of all else exact, however far the factors are apart.
int rank(const StackEntry& entry);
/// What is known of the product's rank, for normal_matrices: the least of its factors' ranks where that is below 3; 3 where all
/// are invertible and rounding has left the product the determinant that it has by theirs. Empty otherwise, and where an
/// entry is not affine: the 3×3 part is then not all of its map.
std::optional<int> known_rank(std::span<const StackEntry> stack);
/// The product of the entries, the first of which acts on the object first: M = last … first. Divided as an
/// entry's matrix is.
glm::dmat4 product(std::span<const StackEntry> stack);

/// (M3⁻¹)ᵀ accumulated from the single entries' inverse transposes in the original order,
/// ((R S)⁻¹)ᵀ = (R⁻¹)ᵀ (S⁻¹)ᵀ, so that no composite is ever inverted. Empty if any entry has no inverse.
std::optional<glm::dmat3> composite_of_inverse_transposes(std::span<const StackEntry> stack);
/// The same in the reverse order, as of one who takes A⁻¹ B⁻¹ for (AB)⁻¹: a mistake, unless they commute.
std::optional<glm::dmat3> reversed_composite_of_inverse_transposes(std::span<const StackEntry> stack);

}  // namespace normalscope

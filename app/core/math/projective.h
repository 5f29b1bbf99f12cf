#pragma once

#include <glm/mat4x4.hpp>

#include <optional>

namespace normalscope {

// What of a 4×4 matrix its upper left 3×3 does not tell: points are divided by their w, so that a common factor of all its
// entries changes nothing, and a bottom row other than 0 0 0 s bends more than it moves.

/// Whether the bottom row is 0 0 0 1, so that M is a linear map and a translation.
bool is_affine(const glm::dmat4& m);

/// M divided by s where its bottom row is 0 0 0 s, but for rounding: the same map, and plainly affine. Any other as it is.
glm::dmat4 with_unit_w(const glm::dmat4& m);

/// The numerical rank, 0 to 4, of the entries of its rows, each taken as long as the others.
int rank_of(const glm::dmat4& m);

/// (M⁻¹)ᵀ: a plane (n, −n·p) goes by it as points go by M. Empty where M has no inverse.
std::optional<glm::dmat4> planes_by(const glm::dmat4& m);

}  // namespace normalscope

#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <string_view>

namespace normalscope {

/// How a normal is taken from object space to world space.
enum class Rule { Naive, InverseTranspose, Cofactor };
inline constexpr std::array kRules{Rule::Naive, Rule::InverseTranspose, Rule::Cofactor};

/// One value a rule, by the rule or in the order of kRules.
template <class T>
struct ByRule : std::array<T, kRules.size()> {
    using std::array<T, kRules.size()>::operator[];
    constexpr T& operator[](Rule rule) { return (*this)[static_cast<std::size_t>(rule)]; }
    constexpr const T& operator[](Rule rule) const { return (*this)[static_cast<std::size_t>(rule)]; }
};

/// The rule's name in scenes, options and numbers: "naive", "inverse-transpose", "cofactor".
std::string_view name(Rule rule);
/// The rule as mathematics, for labels: "M n", "(M⁻¹)ᵀ n", "cof(M) n".
std::string_view formula(Rule rule);

/// A = U diag(σ) Vᵀ with σ.x ≥ σ.y ≥ σ.z ≥ 0 and U, V orthogonal.
struct SingularValues {
    glm::dmat3 u{1.0};
    glm::dvec3 sigma{1.0};
    glm::dmat3 v{1.0};
};

/// One-sided Jacobi (Demmel & Veselić, 1992: small singular values keep their relative accuracy, which the usual
/// detour over AᵀA loses).
SingularValues singular_values(const glm::dmat3& a);

/// The 3×3 matrix of each rule for one M3, with the numbers that tell whether and how they differ.
struct NormalMatrices {
    glm::dmat3 naive{1.0};                        ///< M3
    std::optional<glm::dmat3> inverse_transpose;  ///< (M3⁻¹)ᵀ; empty where rank < 3
    glm::dmat3 cofactor{1.0};                     ///< cof(M3) = det(M3) (M3⁻¹)ᵀ; exists always, zero where rank < 2
    double determinant = 1.0;                     ///< det(M3), exactly 0 where rank < 3
    int rank = 3;           ///< numerical rank: singular values above 4ε σmax, unless it is known from elsewhere
    glm::dvec3 sigma{1.0};  ///< singular values of M3, descending; exactly 0 beyond the rank
    /// σmax/σmin; empty where M3 has no inverse.
    std::optional<double> condition() const;
    /// The largest angle in degrees that any normal's naive image can be off: atan k − atan 1/k with k = σmax/σmin.
    /// From Kantorovich's inequality cos ≥ 2 σmax σmin / (σmax² + σmin²), which is attained halfway between the
    /// two stretch axes. Empty where M3 has no inverse. The same of between_the_rules for another `power`.
    std::optional<double> error_bound_degrees(double power = 1.0) const;
    /// The matrix of `rule`; empty where it does not exist.
    std::optional<glm::dmat3> by(Rule rule) const;
};

/// `known_rank`: of a product, the least of its factors' ranks. Below 3, it has at most that one: rounding may leave it with a
/// tiny third singular value, and its inverse would be noise. With 3 it is invertible, however unevenly it stretches, as
/// long as rounding has left its determinant any digits. Nothing: unknown.
NormalMatrices normal_matrices(const glm::dmat3& m3, std::optional<int> known_rank = {});

/// With M3 = U Σ Vᵀ the matrix U Σᵖ Vᵀ: M3 itself at p = 1, the rotation in it at 0, (M3⁻¹)ᵀ at −1, and a way from the
/// naive rule to the right one in between. A factor of 0 stays 0 as long as p ≥ 0; below that there is no such matrix, and
/// the result is empty.
std::optional<glm::dmat3> between_the_rules(const NormalMatrices& matrices, double power);

/// The largest angle in degrees between U Σᵖ Vᵀ n and (M3⁻¹)ᵀ n of any n: atan k^((p+1)/2) − atan k^(−(p+1)/2), with k the
/// ratio of the largest singular value to the smallest. For p = 1 that is atan k − atan 1/k; it is 0 at p = −1 alone,
/// unless k is 1.
double error_bound_degrees(double k, double power = 1.0);

/// The largest of the entries' absolute values.
double largest_entry(const glm::dmat3& m);

/// The angle between two directions in degrees, 0 to 180, accurate at both ends; empty if either is zero.
std::optional<double> angle_degrees(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace normalscope

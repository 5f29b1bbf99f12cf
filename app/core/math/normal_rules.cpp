#include "core/math/normal_rules.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace normalscope {

namespace {

// Any unit vector perpendicular to the unit vector n (Duff et al., "Building an orthonormal basis, revisited", 2017).
glm::dvec3 perpendicular(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    return {1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

// a·b − c·d to the last digit or two, however much cancels (W. Kahan; the bound is in Jeannerod, Louvet & Muller, "Further
// analysis of Kahan's algorithm for the accurate computation of 2×2 determinants", 2013): the rounding of c·d is found
// exactly by the fused multiply-add, and given back.
double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d, rounding = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + rounding;
}
glm::dvec3 exact_cross(const glm::dvec3& a, const glm::dvec3& b) {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

// √(1 + x²), by operations that are rounded alike everywhere: hypot's last digit differs between processors and C libraries.
double root_of_one_plus_square(double x) {
    constexpr double kOneIsLost = 1e8;  // beside x²; from here on x² need not be finite, either
    return std::abs(x) > kOneIsLost ? std::abs(x) : std::sqrt(1.0 + x * x);
}

// The determinant by the row or column whose products cancel least.
double determinant_by(const glm::dmat3& cofactor, const glm::dmat3& m) {
    double best = glm::dot(m[0], cofactor[0]), least = std::numeric_limits<double>::infinity();
    for (const auto& [a, c] : {std::pair{m, cofactor}, std::pair{glm::transpose(m), glm::transpose(cofactor)}})
        for (int k = 0; k < 3; ++k) {
            const double terms = glm::dot(glm::abs(a[k]), glm::abs(c[k]));
            if (terms < least) {
                least = terms;
                best = glm::dot(a[k], c[k]);
            }
        }
    return best;
}

// The determinant where it is more than what errors in the entries' last digits could make of zero; else empty.
std::optional<double> determinant_beyond_rounding(const glm::dmat3& cofactor, const glm::dmat3& m) {
    const auto terms = [](double a, double b, double c, double d) { return std::abs(a * b) + std::abs(c * d); };
    const double all = std::abs(m[0].x) * terms(m[1].y, m[2].z, m[1].z, m[2].y) +
                       std::abs(m[0].y) * terms(m[1].z, m[2].x, m[1].x, m[2].z) +
                       std::abs(m[0].z) * terms(m[1].x, m[2].y, m[1].y, m[2].x);
    const double determinant = determinant_by(cofactor, m);
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
    return std::abs(determinant) > kRounding * all ? std::optional(determinant) : std::nullopt;
}

}  // namespace

double largest_entry(const glm::dmat3& a) {
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(a[c][r]));
    return largest;
}

std::string_view name(Rule rule) {
    switch (rule) {
        case Rule::Naive: return "naive";
        case Rule::InverseTranspose: return "inverse-transpose";
        case Rule::Cofactor: return "cofactor";
    }
    return "";
}

std::string_view formula(Rule rule) {
    switch (rule) {
        case Rule::Naive: return "M n";
        case Rule::InverseTranspose: return "(M\u207B\u00B9)\u1D40 n";
        case Rule::Cofactor: return "cof(M) n";
    }
    return "";
}

SingularValues singular_values(const glm::dmat3& a) {
    const double scale = largest_entry(a);
    if (scale == 0.0) return {.u = glm::dmat3(1.0), .sigma = glm::dvec3(0.0), .v = glm::dmat3(1.0)};

    // Rotate pairs of columns until all are perpendicular: then W = A V has columns σᵢ uᵢ.
    glm::dmat3 w = a / scale, v(1.0);
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    for (int sweep = 0; sweep < 40; ++sweep) {
        bool rotated = false;
        for (const auto& [i, j] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
            const double alpha = glm::dot(w[i], w[i]), beta = glm::dot(w[j], w[j]), gamma = glm::dot(w[i], w[j]);
            if (std::abs(gamma) <= kEpsilon * std::sqrt(alpha * beta)) continue;
            rotated = true;
            const double zeta = (beta - alpha) / (2.0 * gamma);
            const double t = std::copysign(1.0, zeta) / (std::abs(zeta) + root_of_one_plus_square(zeta));
            const double c = 1.0 / root_of_one_plus_square(t), s = c * t;
            for (glm::dmat3* m : {&w, &v}) {
                const glm::dvec3 mi = (*m)[i];
                (*m)[i] = c * mi - s * (*m)[j];
                (*m)[j] = s * mi + c * (*m)[j];
            }
        }
        if (!rotated) break;
    }

    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return glm::length(w[i]) > glm::length(w[j]); });
    SingularValues result;
    for (int k = 0; k < 3; ++k) {
        const int from = order[static_cast<std::size_t>(k)];
        const double length = glm::length(w[from]);
        result.sigma[k] = scale * length;
        result.v[k] = v[from];
        // Where σ vanishes, any u that completes the orthogonal matrix will do.
        if (length > 0.0)
            result.u[k] = w[from] / length;
        else if (k == 2)
            result.u[k] = glm::cross(result.u[0], result.u[1]);
        else
            result.u[k] = perpendicular(result.u[0]);
    }
    return result;
}

std::optional<double> NormalMatrices::condition() const {
    if (rank < 3) return std::nullopt;
    return sigma.x / sigma.z;
}

std::optional<double> NormalMatrices::error_bound_degrees(double power) const {
    const std::optional<double> k = condition();
    return k ? std::optional(normalscope::error_bound_degrees(*k, power)) : std::nullopt;
}

std::optional<glm::dmat3> NormalMatrices::by(Rule rule) const {
    switch (rule) {
        case Rule::Naive: return naive;
        case Rule::InverseTranspose: return inverse_transpose;
        case Rule::Cofactor: return cofactor;
    }
    return std::nullopt;
}

NormalMatrices normal_matrices(const glm::dmat3& m3, std::optional<int> known_rank) {
    NormalMatrices result;
    result.naive = m3;
    // The columns of the cofactor matrix are the cross products of the columns of M3: a surface element a × b goes to
    // (M3 a) × (M3 b) = cof(M3)(a × b). No inverse and no division is involved. Each entry is right to its last digits:
    // with plain cross products a condition number of 10⁸ leaves normals that are visibly not perpendicular.
    result.cofactor = glm::dmat3(exact_cross(m3[1], m3[2]), exact_cross(m3[2], m3[0]), exact_cross(m3[0], m3[1]));
    result.sigma = singular_values(m3).sigma;
    // Below 1e-90 the determinant, and at last the cofactors, would underflow: such a matrix counts as zero.
    constexpr double kZero = 1e-90;
    const double smallest = std::max(4.0 * std::numeric_limits<double>::epsilon() * result.sigma.x, kZero);
    result.rank = 0;
    while (result.rank < known_rank.value_or(3) && result.sigma[result.rank] > smallest) ++result.rank;
    if (known_rank == 3 && result.rank < 3 && result.sigma.y > kZero)
        if (const auto d = determinant_beyond_rounding(result.cofactor, m3)) {
            result.rank = 3;
            result.sigma.z = std::abs(*d) / result.sigma.x / result.sigma.y;
        }
    for (int i = result.rank; i < 3; ++i) result.sigma[i] = 0.0;
    result.determinant = result.rank == 3 ? determinant_by(result.cofactor, m3) : 0.0;
    if (result.rank < 2) result.cofactor = glm::dmat3(0.0);
    if (result.rank == 3) result.inverse_transpose = result.cofactor / result.determinant;
    return result;
}

std::optional<glm::dmat3> between_the_rules(const NormalMatrices& matrices, double power) {
    if (power == 1.0) return matrices.naive;
    if (power == -1.0) return matrices.inverse_transpose;
    if (power < 0.0 && matrices.rank < 3) return std::nullopt;
    SingularValues svd = singular_values(matrices.naive);
    for (int k = 0; k < 3; ++k) svd.u[k] *= k < matrices.rank ? std::pow(svd.sigma[k], power) : 0.0;
    return svd.u * glm::transpose(svd.v);
}

// With q = (p+1)/2 and z = Σ^((p−1)/2) Vᵀ n the two images are U Σ^q z and U Σ^(−q) z: Kantorovich's inequality again, for
// the stretches σ^q. The worst z is halfway between the axes of the largest and the smallest.
double error_bound_degrees(double k, double power) {
    const double bent = std::pow(k, (power + 1.0) / 2.0);
    return glm::degrees(std::atan(bent) - std::atan(1.0 / bent));
}

std::optional<double> angle_degrees(const glm::dvec3& a, const glm::dvec3& b) {
    const double la = glm::length(a), lb = glm::length(b);
    if (!(la > 0.0) || !(lb > 0.0)) return std::nullopt;
    // Kahan's form: acos loses half the digits near 0° and 180°.
    const glm::dvec3 ua = a / la, ub = b / lb;
    return glm::degrees(2.0 * std::atan2(glm::length(ua - ub), glm::length(ua + ub)));
}

}  // namespace normalscope

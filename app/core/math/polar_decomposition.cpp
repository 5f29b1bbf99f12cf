#include "core/math/polar_decomposition.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr double kSameFactor = 1e-9;  // relative: two factors this close leave their axes to chance

// Turns a vector's largest component positive.
double facing(const glm::dvec3& v) {
    const glm::dvec3 a = glm::abs(v);
    const int largest = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    return v[largest] < 0.0 ? -1.0 : 1.0;
}

// Axis and angle of a rotation by its quaternion (Shepperd, "Quaternion from rotation matrix", 1978: starting from the
// largest of its components loses no digits at 0° or 180°).
void axis_and_angle(const glm::dmat3& r, glm::dvec3& axis, double& degrees) {
    const std::array<double, 4> squares{1.0 + r[0].x + r[1].y + r[2].z, 1.0 + r[0].x - r[1].y - r[2].z,
                                        1.0 - r[0].x + r[1].y - r[2].z,
                                        1.0 - r[0].x - r[1].y + r[2].z};      // 4w², 4x², 4y², 4z²
    const glm::dvec3 odd(r[1].z - r[2].y, r[2].x - r[0].z, r[0].y - r[1].x);  // 4w(x, y, z)
    const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
    const double twice = std::sqrt(std::max(squares[static_cast<std::size_t>(largest)], 0.0));
    double w = twice;
    glm::dvec3 v = odd / twice;
    if (largest > 0) {
        const auto i = static_cast<int>(largest) - 1;
        for (int k = 0; k < 3; ++k) v[k] = k == i ? twice : (r[i][k] + r[k][i]) / twice;
        w = odd[i] / twice;
    }
    if (w < 0.0) v = -v;
    const double length = glm::length(v);
    degrees = glm::degrees(2.0 * std::atan2(length, std::abs(w)));
    if (degrees < 1e-12) degrees = 0.0;
    axis = degrees > 0.0 ? v / length : glm::dvec3(0.0, 0.0, 1.0);
    // Half a turn one way is half a turn the other way.
    if (degrees > 180.0 - 1e-9) axis *= facing(axis);
}

WorstNormal worst_normal(const SingularValues& svd, double power, double degrees) {
    // With n = V y and z = Σ^((p−1)/2) y, the images U Σᵖ y and U Σ⁻¹ y are U Σ^q z and U Σ^(−q) z, where q = (p+1)/2. The
    // cosine between them is z·z / (|Σ^q z| |Σ^(−q) z|). By Kantorovich's inequality it is at least 2 a c / (a² + c²) with
    // a = σmax^q and c = σmin^q, and z = (1, 0, ±1)/√2 attains it: there the images are (a, 0, ±c) and (1/a, 0, ±1/c). For
    // M3 itself y is z, halfway between the two axes.
    const double q = (power + 1.0) / 2.0, a = std::pow(svd.sigma.x, q), c = std::pow(svd.sigma.z, q),
                 from_a = std::pow(svd.sigma.x, 1.0 - q), from_c = std::pow(svd.sigma.z, 1.0 - q);
    WorstNormal result;
    result.degrees = degrees;
    for (const std::size_t i : {0U, 1U}) {
        const double side = i == 0 ? 1.0 : -1.0;
        result.object[i] = {glm::normalize(from_a * svd.v[0] + side * from_c * svd.v[2])};
        result.naive[i] = {glm::normalize(a * svd.u[0] + side * c * svd.u[2])};
        result.right[i] = {glm::normalize(c * svd.u[0] + side * a * svd.u[2])};
    }
    return result;
}

// An axis has no front: each is turned one way, so that it does not jump about as M changes.
SingularValues steady_singular_values(const NormalMatrices& matrices) {
    SingularValues svd = singular_values(matrices.naive);
    svd.sigma = matrices.sigma;  // exactly 0 beyond the rank
    for (int k = 0; k < 3; ++k) {
        const double sign = facing(svd.v[k]);
        svd.v[k] *= sign;
        svd.u[k] *= sign;
    }
    return svd;
}

}  // namespace

std::optional<WorstNormal> worst_normal(const NormalMatrices& matrices, double power) {
    const auto degrees = matrices.error_bound_degrees(power);
    if (!degrees) return std::nullopt;
    return worst_normal(steady_singular_values(matrices), power, *degrees);
}

Decomposition decomposition(const glm::dmat3& m3, std::optional<int> known_rank) {
    const NormalMatrices matrices = normal_matrices(m3, known_rank);
    SingularValues svd = steady_singular_values(matrices);
    // Where σ is 0, u may as well point the other way: then there need be no reflection.
    const double turns = glm::determinant(svd.u) * glm::determinant(svd.v);
    if (matrices.rank < 3 && turns < 0.0) svd.u[2] = -svd.u[2];

    Decomposition result;
    result.unique = matrices.rank == 3;
    result.reflects = matrices.rank == 3 && turns < 0.0;
    result.rotation = svd.u * glm::transpose(svd.v);
    result.stretch = glm::dmat3(0.0);
    for (int k = 0; k < 3; ++k) result.stretch += svd.sigma[k] * glm::outerProduct(svd.v[k], svd.v[k]);
    if (result.reflects) {
        // −R is a rotation by φ about a; R is then the mirror image along a, turned by φ + 180° about a.
        axis_and_angle(-result.rotation, result.axis, result.degrees);
        result.degrees = 180.0 - result.degrees;
        result.axis = -result.axis;
        if (result.degrees < 1e-9) {
            result.degrees = 0.0;
            result.axis *= facing(result.axis);
        }
    } else {
        axis_and_angle(result.rotation, result.axis, result.degrees);
    }
    for (int k = 0; k < 3; ++k) {
        StretchAxis& axis = result.axes[static_cast<std::size_t>(k)];
        axis = {{svd.v[k]}, {svd.u[k]}, svd.sigma[k], true};
        for (int other = 0; other < 3; ++other)
            if (other != k && std::abs(svd.sigma[k] - svd.sigma[other]) <= kSameFactor * svd.sigma.x)
                axis.unique = false;
    }
    if (matrices.rank == 3) result.worst = worst_normal(svd, 1.0, *matrices.error_bound_degrees());
    return result;
}

}  // namespace normalscope

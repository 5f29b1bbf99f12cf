#include "core/math/stack.h"

#include "core/base/overload.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace normalscope {

namespace {

// Quarter turns are common in lessons: take them exactly, so that no 6e-17 shows in a matrix.
double exact_sin(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    if (std::fmod(turn, 180.0) == 0.0) return 0.0;
    if (turn == 90.0 || turn == -90.0) return std::copysign(1.0, turn);
    return std::sin(glm::radians(turn));
}
double exact_cos(double degrees) { return exact_sin(90.0 - std::remainder(degrees, 360.0)); }

// Rodrigues' rotation formula: R = cos θ I + (1 − cos θ) a aᵀ + sin θ [a]×.
glm::dmat3 rotation(const glm::dvec3& axis, double degrees) {
    const double length = glm::length(axis);
    if (!(length > 0.0)) return glm::dmat3(1.0);
    const glm::dvec3 a = axis / length;
    const double c = exact_cos(degrees), s = exact_sin(degrees);
    const glm::dmat3 cross_matrix(0.0, a.z, -a.y, -a.z, 0.0, a.x, a.y, -a.x, 0.0);
    return c * glm::dmat3(1.0) + (1.0 - c) * glm::outerProduct(a, a) + s * cross_matrix;
}

}  // namespace

std::string_view name(const StackEntry& entry) {
    constexpr std::array<std::string_view, 5> kNames{"scale", "rotate", "translate", "shear", "matrix"};
    return kNames.at(entry.index());
}

glm::dmat4 matrix(const StackEntry& entry) {
    return std::visit(Overload{
                          [](const Scale& s) { return glm::scale(glm::dmat4(1.0), s.factors); },
                          [](const Rotate& r) { return glm::dmat4(rotation(r.axis, r.degrees)); },
                          [](const Translate& t) { return glm::translate(glm::dmat4(1.0), t.offset); },
                          [](const Shear& s) {  // columns: where x, y and z go
                              return glm::dmat4(glm::dmat3(1.0, s.yx, s.zx, s.xy, 1.0, s.zy, s.xz, s.yz, 1.0));
                          },
                          [](const Matrix& m) { return with_unit_w(m.matrix); },
                      },
                      entry);
}

int rank(const StackEntry& entry) {
    return std::visit(
        Overload{
            [](const Scale& s) {
                return static_cast<int>((s.factors.x != 0.0) + (s.factors.y != 0.0) + (s.factors.z != 0.0));
            },
            [](const Rotate&) { return 3; },
            [](const Translate&) { return 3; },
            [](const auto& other) {
                const bool shears = std::is_same_v<std::decay_t<decltype(other)>, Shear>;
                return normal_matrices(glm::dmat3(matrix(other)), shears ? std::optional(3) : std::nullopt).rank;
            },
        },
        entry);
}

StackEntry partly(const StackEntry& entry, double part) {
    const auto from_one = [&](const auto& to) { return (1.0 - part) * std::decay_t<decltype(to)>(1.0) + part * to; };
    return std::visit(Overload{
                          [&](const Scale& s) -> StackEntry { return Scale{from_one(s.factors)}; },
                          [&](const Rotate& r) -> StackEntry { return Rotate{r.axis, part * r.degrees}; },
                          [&](const Translate& t) -> StackEntry { return Translate{part * t.offset}; },
                          [&](const Shear& s) -> StackEntry {
                              return Shear{part * s.xy, part * s.xz, part * s.yx,
                                           part * s.yz, part * s.zx, part * s.zy};
                          },
                          [&](const Matrix& m) -> StackEntry { return Matrix{from_one(m.matrix)}; },
                      },
                      entry);
}

glm::dmat4 product(std::span<const StackEntry> stack) {
    glm::dmat4 m(1.0);
    for (const StackEntry& entry : stack) m = matrix(entry) * m;
    return with_unit_w(m);
}

std::optional<int> known_rank(std::span<const StackEntry> stack) {
    int least = 3;
    double determinant = 1.0;
    for (const StackEntry& entry : stack) {
        const glm::dmat4 m = matrix(entry);
        if (!is_affine(m)) return std::nullopt;
        const int of_entry = rank(entry);
        least = std::min(least, of_entry);
        determinant *= normal_matrices(glm::dmat3(m), of_entry).determinant;
    }
    if (least < 3) return least;
    constexpr double kSame = 1e-6;
    const double left = normal_matrices(glm::dmat3(product(stack)), 3).determinant;
    return std::abs(left - determinant) <= kSame * std::abs(determinant) ? std::optional(3) : std::nullopt;
}

std::optional<glm::dmat3> composite_of_inverse_transposes(std::span<const StackEntry> stack) {
    glm::dmat3 composite(1.0);
    for (const StackEntry& entry : stack) {
        const auto single = normal_matrices(glm::dmat3(matrix(entry)), rank(entry)).inverse_transpose;
        if (!single) return std::nullopt;
        composite = *single * composite;
    }
    return composite;
}

std::optional<glm::dmat3> reversed_composite_of_inverse_transposes(std::span<const StackEntry> stack) {
    return composite_of_inverse_transposes(std::vector<StackEntry>(stack.rbegin(), stack.rend()));
}

}  // namespace normalscope

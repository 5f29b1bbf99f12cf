#include "core/math/map_class.h"

#include "core/math/transform.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace normalscope {

namespace {

bool nearly(const glm::dmat3& a, const glm::dmat3& b, double size) {
    return largest_entry(a - b) <= kClassTolerance * size;
}

bool is_of(MapClass map_class, const glm::dmat4& m, const NormalMatrices& matrices) {
    const glm::dmat3 m3(m), identity(1.0);
    const double size = largest_entry(m3), sigma = matrices.sigma.x;
    const bool even = matrices.rank == 3 && sigma - matrices.sigma.z <= kClassTolerance * sigma;
    const bool unit = even && std::abs(sigma - 1.0) <= kClassTolerance;
    switch (map_class) {
        case MapClass::Translation: return is_affine(m) && nearly(m3, identity, 1.0);
        case MapClass::Rotation: return is_affine(m) && unit && matrices.determinant > 0.0;
        case MapClass::UniformScale: return is_affine(m) && even && !unit;
        case MapClass::Reflection: return is_affine(m) && matrices.determinant < 0.0;
        case MapClass::UnevenScale:
            return is_affine(m) && matrices.rank == 3 && !even && nearly(m3, glm::transpose(m3), size);
        case MapClass::Shear: {
            const glm::dmat3 slide = m3 - identity;
            const double length = largest_entry(slide);
            return is_affine(m) && matrices.rank == 3 && length > kClassTolerance &&
                   nearly(slide * slide, glm::dmat3(0.0), length * std::max(length, 1.0));
        }
        case MapClass::Singular: return matrices.rank < 3;
        case MapClass::NotAffine: return !is_affine(m);
        case MapClass::General:
            if (!is_affine(m)) return false;
            for (const MapClass other : kMapClasses)
                if (other != MapClass::General && other != MapClass::Reflection && is_of(other, m, matrices))
                    return false;
            // A mirror image alone is no more than a reflection; one that also stretches unevenly is more.
            return matrices.determinant > 0.0 || !even;
    }
    return false;
}

// What stands in a class's row when M is not of it.
glm::dmat4 example(MapClass map_class) {
    const glm::dmat4 identity(1.0);
    glm::dmat4 m(1.0);
    switch (map_class) {
        case MapClass::Translation: return glm::translate(identity, {1.0, 2.0, 3.0});
        case MapClass::Rotation: return glm::rotate(identity, glm::radians(30.0), {0.0, 0.0, 1.0});
        case MapClass::UniformScale: return glm::scale(identity, {2.0, 2.0, 2.0});
        case MapClass::Reflection: return glm::scale(identity, {-1.0, 1.0, 1.0});
        case MapClass::UnevenScale: return glm::scale(identity, {1.0, 2.0, 1.0});
        case MapClass::Shear: m[1].x = 1.0; return m;
        case MapClass::Singular: return glm::scale(identity, {1.0, 1.0, 0.0});
        case MapClass::General:
            return glm::rotate(identity, glm::radians(30.0), {0.0, 0.0, 1.0}) * glm::scale(identity, {1.0, 2.0, 1.0});
        case MapClass::NotAffine: m[2].w = -0.5; return m;
    }
    return m;
}

}  // namespace

std::string_view name(MapClass map_class) {
    constexpr std::array<std::string_view, 9> kNames{"translation", "rotation",     "uniform scale",
                                                     "reflection",  "uneven scale", "shear",
                                                     "singular",    "general",      "not affine"};
    return kNames.at(static_cast<std::size_t>(map_class));
}

std::string_view meaning(MapClass map_class) {
    constexpr std::array<std::string_view, 9> kMeanings{"M₃ = I",
                                                        "M₃ᵀ M₃ = I, det M₃ > 0",
                                                        "M₃ᵀ M₃ = s² I, s ≠ 1",
                                                        "det M₃ < 0",
                                                        "M₃ = M₃ᵀ, factors differ",
                                                        "(M₃ − I)² = 0, M₃ ≠ I",
                                                        "M₃ has no inverse",
                                                        "any other affine map",
                                                        "bottom row not 0 0 0 1"};
    return kMeanings.at(static_cast<std::size_t>(map_class));
}

std::string_view name(CofactorGives gives) {
    constexpr std::array<std::string_view, 4> kNames{"the same direction", "the opposite direction",
                                                     "the only one that exists", "zero"};
    return kNames.at(static_cast<std::size_t>(gives));
}

MapClaims claims(const glm::dmat4& m, std::optional<int> known_rank) {
    const NormalMatrices matrices = normal_matrices(glm::dmat3(m), known_rank);
    MapClaims result;
    result.rank = matrices.rank;
    result.condition = matrices.condition();
    if (result.condition) result.digits_lost = std::max(std::log10(*result.condition), 0.0);
    result.inverse_transpose_exists = matrices.inverse_transpose.has_value();
    result.worst_degrees = matrices.error_bound_degrees();
    if (result.worst_degrees) result.naive_direction_right = *result.condition - 1.0 <= kClassTolerance;
    if (matrices.rank == 2) {
        // The true normal is perpendicular to the plane that M3 flattens to, and every M3 n lies in that plane.
        result.worst_degrees = 90.0;
        result.naive_direction_right = false;
    }
    result.naive_length_right =
        std::abs(matrices.sigma.x - 1.0) <= kClassTolerance && std::abs(matrices.sigma.z - 1.0) <= kClassTolerance;
    result.cofactor = matrices.rank < 2            ? CofactorGives::Zero
                      : matrices.rank < 3          ? CofactorGives::OnlyOneThatExists
                      : matrices.determinant < 0.0 ? CofactorGives::OppositeDirection
                                                   : CofactorGives::SameDirection;
    if (!is_affine(m)) {
        result.naive_direction_right = result.naive_length_right = std::nullopt;
        result.worst_degrees = std::nullopt;  // the closed form is about M3 alone
    }
    return result;
}

std::vector<MapClassRow> map_classes(const glm::dmat4& m, std::optional<int> known_rank) {
    const NormalMatrices matrices = normal_matrices(glm::dmat3(m), known_rank);
    std::vector<MapClassRow> rows;
    for (const MapClass map_class : kMapClasses) {
        MapClassRow row{.map_class = map_class, .contains_m = is_of(map_class, m, matrices)};
        row.of = row.contains_m ? m : example(map_class);
        row.claims = claims(row.of, row.contains_m ? known_rank : std::nullopt);
        rows.push_back(row);
    }
    return rows;
}

}  // namespace normalscope

#pragma once

#include "core/math/normal_rules.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <string_view>
#include <vector>

namespace normalscope {

/// Kinds of maps. One M may be of several: a translation by nothing is a rotation by nothing, too.
enum class MapClass {
    Translation,   ///< M3 = I
    Rotation,      ///< M3ᵀ M3 = I, det > 0; about any place
    UniformScale,  ///< M3ᵀ M3 = s² I, s ≠ 1: perhaps turned as well
    Reflection,    ///< det < 0: it turns the winding over, whatever else it does
    UnevenScale,   ///< M3 symmetric, its factors not all the same in size: along axes that stay where they are
    Shear,         ///< (M3 − I)² = 0 but M3 ≠ I: layers slide along themselves
    Singular,      ///< M3 has no inverse
    General,       ///< any other affine map: each is a rotation after an uneven scale
    NotAffine,     ///< the bottom row is not 0 0 0 1
};
inline constexpr std::array kMapClasses{MapClass::Translation, MapClass::Rotation,    MapClass::UniformScale,
                                        MapClass::Reflection,  MapClass::UnevenScale, MapClass::Shear,
                                        MapClass::Singular,    MapClass::General,     MapClass::NotAffine};
std::string_view name(MapClass map_class);     ///< "translation", …, "uniform scale", …, "not affine"
std::string_view meaning(MapClass map_class);  ///< what makes an M one: "M₃ = I"

/// Deviations up to this, relative to what is compared, still count as being of a class.
inline constexpr double kClassTolerance = 1e-9;

enum class CofactorGives { SameDirection, OppositeDirection, OnlyOneThatExists, Zero };
std::string_view name(CofactorGives gives);  ///< "the same direction", "the opposite direction", …

/// What can be said of normals under one M, computed from it. Where M is not affine: of its M3.
struct MapClaims {
    /// Has M3 n the true normal's direction for every n? Where only the cofactor gives a normal, that one is the true one;
    /// empty where there is none to compare with, and where M is not affine: then it depends on the place.
    std::optional<bool> naive_direction_right;
    /// How far off it can be: the closed form; 90° where M3 has rank 2, since M3 n then lies in the flattened object.
    std::optional<double> worst_degrees;
    std::optional<bool> naive_length_right;  ///< does M3 n keep n's length for every n? All stretch factors are 1 then
    bool inverse_transpose_exists = true;
    CofactorGives cofactor = CofactorGives::SameDirection;
    int rank = 3;
    std::optional<double> condition;    ///< σmax/σmin
    std::optional<double> digits_lost;  ///< log10 of the condition number, of the 16 that a double has
};
/// `known_rank` as in normal_matrices.
MapClaims claims(const glm::dmat4& m, std::optional<int> known_rank = {});

struct MapClassRow {
    MapClass map_class = MapClass::Translation;
    bool contains_m = false;
    glm::dmat4 of{
        1.0};  ///< what the claims are computed from: M where the class contains it, else an example of the class
    MapClaims claims;
};
/// A row for each class, in the order of kMapClasses. At least one contains M.
std::vector<MapClassRow> map_classes(const glm::dmat4& m, std::optional<int> known_rank = {});

}  // namespace normalscope

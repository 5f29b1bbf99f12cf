#pragma once

#include "core/math/expression.h"
#include "core/surface/probe.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// The lines of the derivation in their order (core/explain/derivation.h), as far as the picture has something to show.
enum class DerivationLine {
    Given,
    Wanted,
    Tangent,
    AsMatrices,
    TransposedTwice,
    ProductOfTransposes,
    AsDotProduct,
    SameDirection,
    Solved,
    Rule,
};
inline constexpr std::size_t kDerivationLines = 10;

/// Whether the line carries an arrow from one space to the other.
constexpr bool carries(DerivationLine line) {
    return line == DerivationLine::Tangent || line == DerivationLine::ProductOfTransposes ||
           line == DerivationLine::Solved;
}

/// One line, and how far what it carries from one space to the other has come: 0 … 1.
struct DerivationAt {
    DerivationLine line = DerivationLine::Given;
    std::size_t tangent = 0;
    double carried = 1.0;
    friend bool operator==(const DerivationAt&, const DerivationAt&) = default;
};

/// An arrow that a line is about; as long as its vector says, against the object's unit normal.
struct CarriedArrow {
    glm::dvec3 base{0.0}, vector{0.0};
    std::string name;
    Meaning meaning = Meaning::Plain;
    bool quiet = false;     ///< where one that is carried has come from
    bool to_scale = false;  ///< an edge of H or MH, from corner to corner
};

/// What a line shows.
struct CarriedArrows {
    std::vector<CarriedArrow> arrows;
    /// Two of them, the normal first, by their places in the list, that make a right angle, once nothing is on its way.
    std::optional<std::array<std::size_t, 2>> right_angle;
};

/// Empty where M leaves no normal there, or is not affine: then the argument is another one.
CarriedArrows carried_arrows(const DerivationAt& at, const ProbeInWorld& probe,
                             const Transform<World, Object>& world_from_object);

}  // namespace normalscope

#pragma once

#include "core/math/expression.h"
#include "core/math/transform.h"
#include "core/surface/probe.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace normalscope {

/// One line of the derivation, with the scene's numbers.
struct Step {
    enum class State {
        Holds,    ///< both sides have values, and differ by no more than rounding
        Fails,    ///< both sides have values, and they differ: here the derivation stops for this M
        NoValue,  ///< a side does not exist for this M, or nothing is probed
    };
    std::string id;      ///< "given", "wanted", "tangent", …: for tests, links and translations
    Expression line;     ///< an equation
    std::string reason;  ///< why this line follows from the one before it
    std::string remark;  ///< what this M makes of the line, where there is something to say; else empty
    State state = State::NoValue;
    std::optional<Difference> residual;  ///< of the left side from the right side

    const Expression& left() const { return line.operands[0]; }
    const Expression& right() const { return line.operands[1]; }
};

/// A line that is a dot product, as one works it out by hand: "0.759·0.418 + 0.549·0 − 0.350·0.908 = 0". Empty for any
/// other, and where a side has no value.
std::string written_out(const Step& step);

std::string_view name(Step::State state);  ///< "holds", "fails", "no-value"

/// One rule's normal, held against the tangents.
struct RuleCheck {
    Rule rule = Rule::Naive;
    std::optional<Value> normal;  ///< in world space, not normalised; empty where there is none, or it is zero
    std::array<std::optional<Value>, 2> dots;              ///< n_world · v_world
    std::array<std::optional<double>, 2> degrees_between;  ///< normal and tangent: 90° where it is right
    std::optional<double> degrees_off;  ///< from the true normal's direction (either sign for the cofactor's)
};

/// Why translation drops out: M acting on a point, with w = 1, and on a vector, with w = 0.
struct HomogeneousDemo {
    Value m;                                     ///< 4×4
    std::array<std::optional<Value>, 2> before;  ///< point, vector, in object space
    std::array<std::optional<Value>, 2> after;   ///< M times these
    std::optional<Value> normal_as_point;        ///< M times (n_obj, 1): the translation leaks in
    std::string reason;
};

/// "Why the inverse transpose?", from what a normal is to the rule.
struct Derivation {
    bool affine = true;  ///< where M is not, tangents go by its Jacobian at the probe, and n_world comes from that, too
    /// Whose normal n_world is: the inverse transpose's or, at rank 2, the cofactor's. Empty: there is no normal, or M is
    /// not affine, and no rule gives it.
    std::optional<Rule> n_world_by;
    std::optional<Value> n_world;
    std::vector<Step> steps;
    ByRule<RuleCheck> checks;
    HomogeneousDemo homogeneous;
};

/// `factors`: how many matrices M was multiplied from. `tangent`: which of the probe's two tangents v_obj is.
Derivation derivation(const Transform<World, Object>& world_from_object, int factors, const std::optional<Probe>& probe,
                      std::size_t tangent = 0);

}  // namespace normalscope

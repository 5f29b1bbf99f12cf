#include "core/base/decimal.h"
#include "core/lessons/exercise.h"
#include "core/lessons/posing.h"

#include <algorithm>

namespace normalscope {

std::string plain_number(double value) {
    std::string s = with_digits(value, 6);
    if (s.starts_with('-')) s.replace(0, 1, "−");
    return s;
}

std::string diagonal(const glm::dvec3& d) {
    return "diag(" + plain_number(d.x) + ", " + plain_number(d.y) + ", " + plain_number(d.z) + ")";
}

namespace {

Question is_it_rigid(Exercise& e, Dice& dice) {
    const int kind = dice.below(3);
    const double degrees = dice.one_of(std::array{20.0, 35.0, 50.0});
    const Factor f = dice.one_of(kFactors);
    const std::array<glm::dvec3, 3> factors{{glm::dvec3(1.0), glm::dvec3(f.value), glm::dvec3(1.0, f.value, 1.0)}};
    const std::array<std::string, 3> does{"turns and moves the object",
                                          std::string("scales it by ") + f.text + " along every axis, then turns it",
                                          std::string("multiplies y by ") + f.text + ", then turns the object"};
    e.scene.surface = ShapeSurface{.shape = Shape::Cube};
    e.scene.stack = {Rotate{{0, 0, 1}, degrees}, Translate{{0.4, 0.1, 0}}};
    if (kind > 0) e.scene.stack = {Scale{factors[static_cast<std::size_t>(kind)]}, Rotate{{0, 0, 1}, degrees}};
    e.task = "M " + does[static_cast<std::size_t>(kind)] + ".";
    e.why = "The naive rule keeps the direction exactly where M₃ stretches equally in every direction.";
    return {"What becomes of a normal that is sent through M₃?",
            {{"Right as it is: M is rigid", kind == 0,
              kind == 0 ? "M only turns and moves, so (M₃⁻¹)ᵀ = M₃." : "M scales, so at least the length is wrong."},
             {"Right direction, wrong length", kind == 1,
              kind == 1   ? "An even scale keeps all angles: make it a unit vector, and it is right."
              : kind == 0 ? "Nothing is scaled: the length stays, too."
                          : "y is scaled, and x is not: the direction turns."},
             {"Wrong direction", kind == 2,
              kind == 2 ? "y is scaled, and x is not, so slopes and normals turn opposite ways."
                        : "All angles stay as they were, also those between normal and tangents."}}};
}

Question which_matrix(Exercise& e, Dice& dice) {
    const Factor f = dice.one_of(kFactors), g = dice.one_of(kFactors);
    const glm::dvec3 d(f.value, g.value == f.value ? 3.0 : g.value, 1.0);
    e.scene.stack = {Scale{d}};
    e.task = "M₃ = " + diagonal(d) + ".";
    e.why =
        "The inverse of a diagonal matrix has the reciprocals of its entries, and transposing changes nothing there.";
    Question q{"Which matrix takes the normals to the world?",
               {{diagonal(d), false, "That is M₃, the naive rule."},
                {diagonal(1.0 / d), true, "Each coordinate is multiplied by the reciprocal: (M₃⁻¹)ᵀ."},
                {diagonal(-d), false, "A sign turns the normal round. It does not undo the scale."},
                {"The identity", false, "Then the normals would not change, but the tangents do."}}};
    std::rotate(q.choices.begin(), q.choices.begin() + dice.below(4), q.choices.end());
    return q;
}

Question which_rule(Exercise& e, Dice& dice) {
    const bool flat = dice.below(2) == 0;
    e.scene.camera.azimuth = 40.0;
    e.scene.camera.elevation = 15.0;
    e.scene.stack = {Scale{flat ? glm::dvec3(1, 1, 0) : glm::dvec3(-1, 1.5, 1)}};
    e.task = flat ? "M scales z by 0: the object is a flat disc." : "M = diag(−1, 1.5, 1) mirrors and stretches.";
    e.why = flat ? "The cofactor matrix needs no division."
                 : "Gradients are sent through the inverse transpose, whatever the sign.";
    return {flat ? "Which rule still gives the disc’s normal?" : "Which rule keeps the normals on the outside?",
            {{"M n", false,
              flat ? "It sends the normal of the disc, (0, 0, 1), to zero."
                   : "It stretches normals along with the points."},
             {"(M⁻¹)ᵀ n", !flat,
              flat ? "M has no inverse, so there is none."
                   : "It carries gradients: what was outside stays outside, even in the mirror."},
             {"cof(M) n", flat,
              flat ? "It is made of 2×2 determinants, and exists for every M."
                   : "It follows the winding, which the mirror reverses: it points inward here."}}};
}

}  // namespace

Question make_question(Exercise& e, Dice& dice) {
    switch (dice.below(3)) {
        case 0: return is_it_rigid(e, dice);
        case 1: return which_matrix(e, dice);
        default: return which_rule(e, dice);
    }
}

}  // namespace normalscope

#include "core/lessons/exercise.h"

#include "core/base/decimal.h"
#include "core/base/error.h"
#include "core/lessons/posing.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

// What earns all points, and from where on there are none: as far off as the naive rule, within these bounds.
constexpr double kRightWithin = 3.0, kClearlyOff = 15.0, kNoneFrom = 45.0;

std::string tenths(double value) { return with_decimals(value, 1); }

// A bare object and the point's normal; what the answer would give away is left out.
Scene bare_scene() {
    Scene scene;
    scene.surface = ShapeSurface{.shape = Shape::Sphere};
    scene.view = ViewMode::Overlay;
    scene.arrows.show = std::vector<ArrowKind>{ArrowKind::Object};
    scene.arrows.limit = 0;
    scene.arrows.length = 0.16;
    scene.show.axes = false;
    scene.show.legend = false;
    scene.show.tangent_plane = false;
    scene.camera.azimuth = 0.0;
    scene.camera.elevation = 0.0;
    scene.camera.zoom = 0.95;
    return scene;
}

// On the sphere's outline as seen from the front, not too near an axis, where every rule agrees.
void put_on_outline(Exercise& e, Dice& dice) {
    const double a = glm::radians(dice.uniform(25.0, 65.0) + 90.0 * dice.below(4));
    e.normal = {glm::dvec3(std::cos(a), std::sin(a), 0.0)};
    e.at = {e.normal.xyz};
}

bool faces_camera(const Exercise& e) {
    const auto truth = world_from_object(e.scene)(e.normal);
    return truth && glm::dot(glm::normalize(truth->xyz), e.scene.camera.toward_eye().vector().xyz) > 0.15;
}

// Somewhere on the side that faces this camera.
void put_in_front(Exercise& e, Dice& dice) {
    const glm::dvec3 back = e.scene.camera.toward_eye().vector().xyz;
    for (;;) {
        const glm::dvec3 v(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1));
        const double l = glm::length(v);
        if (l < 0.1 || l > 1.0) continue;
        e.normal = {v / l};
        e.at = {e.normal.xyz};
        if (glm::dot(e.normal.xyz, back) > 0.25) return;
    }
}

// An ellipsoid by formula: its normal is the gradient, which is not the point itself.
void put_on_ellipsoid(Exercise& e, Dice& dice) {
    put_in_front(e, dice);
    const glm::dvec3 axes(1.2, 0.8, 1.0);
    const glm::dvec3 p = axes * e.at.xyz;
    e.scene.surface = FormulaSurface{.formula = "x^2/1.44 + y^2/0.64 + z^2 - 1", .bound = 1.5};
    e.at = {p};
    e.normal = {glm::normalize(p / (axes * axes))};
}

std::string turned(double degrees) {
    return "turns it by " + plain_number(std::abs(degrees)) + "° " + (degrees > 0 ? "counterclockwise" : "clockwise");
}

void scale_one(Exercise& e, Dice& dice) {
    const int axis = dice.below(2);
    const Factor f = dice.one_of(kFactors);
    glm::dvec3 factors(1.0);
    factors[axis] = f.value;
    const std::string name(1, "xy"[axis]);
    e.scene.stack = {Scale{factors}};
    e.task = "M multiplies " + name + " by " + f.text + ".";
    e.hints = {"Does the surface get steeper or flatter here? The normal is perpendicular to it.",
               "The normal’s " + name + " is divided by " + f.text + "."};
    e.why = "A point’s " + name + " is multiplied by " + f.text + ", so the normal’s must be multiplied by " +
            f.inverse + ": the reciprocal, or it would not stay perpendicular to the tangents.";
}

void scale_two(Exercise& e, Dice& dice) {
    const Factor f = dice.one_of(kFactors), g = dice.one_of(kFactors);
    e.scene.stack = {Scale{{f.value, g.value, 1.0}}};
    e.task = std::string("M multiplies x by ") + f.text + " and y by " + g.text + ".";
    e.hints = {"Only the ratio counts: the length of a normal means nothing.",
               std::string("Divide: x by ") + f.text + ", y by " + g.text + "."};
    e.why = std::string("(M₃⁻¹)ᵀ = diag(") + f.inverse + ", " + g.inverse +
            ", 1): each coordinate is multiplied by the reciprocal of its factor" +
            (f.value == g.value ? "; both are alike here, so the direction stays." : ".");
}

void scale_and_turn(Exercise& e, Dice& dice) {
    const Factor f = dice.one_of(kFactors);
    const double degrees = dice.one_of(std::array{-60.0, -45.0, -30.0, 30.0, 45.0, 60.0});
    e.scene.stack = {Scale{{1.0, f.value, 1.0}}, Rotate{{0, 0, 1}, degrees}};
    e.task = std::string("M multiplies y by ") + f.text + ", then " + turned(degrees) + ".";
    e.hints = {"One after the other: first the scale, then the rotation.",
               std::string("Divide y by ") + f.text + ", then turn the arrow with the object: (R⁻¹)ᵀ = R."};
    e.why = std::string("The scale acts on the normal by its inverse, y · ") + f.inverse +
            ", and the rotation as on everything else: (R⁻¹)ᵀ = R.";
}

// "y − 0.5 · x"; what is multiplied by 1 stands alone.
std::string plus_multiple(const char* of, double factor, const char* other) {
    const std::string times = std::abs(factor) == 1.0 ? "" : plain_number(std::abs(factor)) + " · ";
    return std::string(of) + (factor < 0.0 ? " − " : " + ") + times + other;
}

void shear(Exercise& e, Dice& dice) {
    const double s = dice.one_of(std::array{-1.0, -0.8, -0.5, 0.5, 0.8, 1.0});
    e.scene.stack = {Shear{.xy = s}};
    e.task = "M shears: x becomes " + plus_multiple("x", s, "y") + ".";
    e.hints = {"Level tangents stay level; the others lean with the shear.",
               "The inverse transpose leaves the normal’s x alone; its y becomes " + plus_multiple("y", -s, "x") + "."};
    e.why = "The inverse slides x back, to " + plus_multiple("x", -s, "y") + "; transposed, that is " +
            plus_multiple("y", -s, "x") + " for the normal’s y.";
}

void mirror(Exercise& e, Dice& dice) {
    const Factor f = dice.one_of(kFactors);
    const int axis = dice.below(2);
    glm::dvec3 factors(1.0, f.value, 1.0);
    factors[axis] *= -1.0;
    e.scene.stack = {Scale{factors}};
    e.task = "M₃ = " + diagonal(factors) + ", a mirror image. Where does the outward normal point?";
    e.hints = {"Where is the point now? The normal leads out of the object there.",
               "Divide each coordinate by its factor, sign and all."};
    e.why = std::string(
        "Each coordinate is divided by its factor, sign and all; so the normal still points outward on the mirrored "
        "object.");
}

void anything(Exercise& e, Dice& dice) {
    const Factor f = dice.one_of(kFactors), g = dice.one_of(kFactors);
    const double degrees = dice.one_of(std::array{-50.0, -35.0, 35.0, 50.0});
    const double s = dice.one_of(std::array{-0.6, 0.6});
    glm::dvec3 axis(0.0);
    axis[dice.below(3)] = 1.0;
    e.scene.stack = {Scale{{f.value, g.value, 1.0}}, Rotate{axis, degrees}};
    e.task = std::string("M multiplies x by ") + f.text + " and y by " + g.text + ", then rotates.";
    e.why =
        "Every factor acts by its own inverse transpose, in the same order: the scale by its inverse, the rotation "
        "as it is.";
    if (dice.below(2) == 0) {
        e.scene.stack.insert(e.scene.stack.begin() + 1, Shear{.xy = s});
        e.task = std::string("M multiplies x by ") + f.text + " and y by " + g.text + ", shears, then rotates.";
        e.why =
            "Every factor acts by its own inverse transpose, in the same order: ((R H S)⁻¹)ᵀ = (R⁻¹)ᵀ (H⁻¹)ᵀ (S⁻¹)ᵀ.";
    }
    e.hints = {"Look at the surface about the point, not at M: which way does it face?",
               "The blue tangents are sent through M. The normal is perpendicular to both."};
}

void pose(Exercise& e, Dice& dice) {
    switch (e.level) {
        case 0: put_on_outline(e, dice), scale_one(e, dice); break;
        case 1: put_on_outline(e, dice), scale_two(e, dice); break;
        case 2: put_on_outline(e, dice), scale_and_turn(e, dice); break;
        case 3: put_on_outline(e, dice), shear(e, dice); break;
        case 4: put_on_outline(e, dice), mirror(e, dice); break;
        default:
            // Until the answer faces the camera, so that an arrow can be dragged there.
            do {
                e.scene = bare_scene();
                e.scene.camera.azimuth = dice.uniform(-40.0, 40.0);
                e.scene.camera.elevation = dice.uniform(5.0, 30.0);
                if (dice.below(2) == 0)
                    put_on_ellipsoid(e, dice);
                else
                    put_in_front(e, dice);
                anything(e, dice);
            } while (!faces_camera(e));
    }
}

void transform(Exercise& e) {
    const Transform<World, Object> m = world_from_object(e.scene);
    if (const auto truth = m(e.normal)) e.truth = {glm::normalize(truth->xyz)};
    e.naive = {glm::normalize(transform_normal_naively(m, e.normal).xyz)};
}

// Where the naive rule is wrong it is so for all to see; an answer like its own must not earn points.
bool tells_the_rules_apart(const Exercise& e) {
    const double off = judge(e, {e.truth.xyz}, 0).naive_off;
    return off == 0.0 || off >= kClearlyOff;
}

// Wherever somebody turns the arrow, it stays in the picture, with the word at its tip.
void make_room(Exercise& e) {
    constexpr double kArrow = 7.0;  // of the others' length
    const Transform<World, Object> m = world_from_object(e.scene);
    const double object = m.normal_matrices_by_rule().sigma.x,
                 tip = glm::length(m(e.at).xyz) + kArrow * e.scene.arrows.length;
    e.scene.camera.zoom = std::min(*e.scene.camera.zoom, Camera::kFramedRadius / std::max(1.05 * object, tip));
}

}  // namespace

Exercise make_exercise(std::uint64_t seed, int number) {
    Dice dice(seed * 0x2545F4914F6CDD1Dull + static_cast<std::uint64_t>(number));
    dice.next();
    Exercise e;
    e.seed = seed;
    e.number = number;
    e.level = std::min(number / 2, kHardestLevel);
    e.scene = bare_scene();
    if (number % 4 == 3) {
        e.scene.show.probe = false;
        e.scene.arrows.show = std::vector<ArrowKind>{};
        e.question = make_question(e, dice);
        e.normal = {{0, 1, 0}};
        e.at = {{0, 1, 0}};
    } else {
        do {
            pose(e, dice);
            transform(e);
        } while (!tells_the_rules_apart(e));
        e.scene.probe = e.at;
    }
    transform(e);
    make_room(e);
    return e;
}

Scene revealed(const Exercise& exercise) {
    Scene scene = exercise.scene;
    if (exercise.question) {
        scene.arrows.show.reset();
        scene.arrows.limit = 80;
        scene.show.legend = true;
        return scene;
    }
    scene.arrows.show = std::vector<ArrowKind>{ArrowKind::Object, ArrowKind::Naive, ArrowKind::InverseTranspose};
    scene.show.tangent_plane = true;
    scene.show.legend = true;
    return scene;
}

Judgement judge(const Exercise& exercise, const Vector<World>& arrow, int hints) {
    const auto off = [&](const glm::dvec3& v, double otherwise) {
        return std::round(10.0 * angle_degrees(v, exercise.truth.xyz).value_or(otherwise)) / 10.0;
    };
    Judgement result;
    result.degrees_off = off(arrow.xyz, 180.0);
    result.naive_off = off(exercise.naive.xyz, 0.0);
    result.none_from = std::clamp(result.naive_off, kClearlyOff, kNoneFrom);
    const double share = (result.none_from - result.degrees_off) / (result.none_from - kRightWithin);
    result.points = std::max(static_cast<int>(kMostPoints * std::clamp(share, 0.0, 1.0)) - 2 * hints, 0);
    return result;
}

std::string verdict(const Exercise& exercise, const Judgement& judgement) {
    return (judgement.degrees_off <= kRightWithin ? "✓ Yours is " : "Yours is ") + tenths(judgement.degrees_off) +
           "° off the right one; the naive rule’s is " + tenths(judgement.naive_off) + "°. " + exercise.why;
}

std::string points_line(const Judgement& judgement) {
    return std::to_string(judgement.points) + " of " + std::to_string(kMostPoints) + " points: all within " +
           plain_number(kRightWithin) + "° of the right one, none from " + plain_number(judgement.none_from) + "° on" +
           (judgement.none_from == judgement.naive_off ? ", where the naive rule’s is" : "") + "; a hint costs 2.";
}

std::optional<ExercisesName> exercises_name(const std::string& name) {
    constexpr std::string_view kName = "exercises";
    if (name == kName) return ExercisesName{};
    if (!name.starts_with(std::string(kName) + ":")) return std::nullopt;
    const std::string digits = name.substr(kName.size() + 1);
    if (digits.empty() || digits.size() > 18 || digits.find_first_not_of("0123456789") != std::string::npos)
        throw InputError(name + ": the seed must be a whole number, such as exercises:42");
    return ExercisesName{std::stoull(digits)};
}

}  // namespace normalscope

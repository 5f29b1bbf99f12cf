// How the derivation ends: the check by dot products, and why the translation drops out.

#include "ui/kit/number_text.h"
#include "ui/tabs/derivation_passages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace normalscope {

namespace {

bool is_zero(const Value& value) {
    for (int r = 0; r < value.rows; ++r)
        for (int c = 0; c < value.columns; ++c)
            if (value.clean(r, c) != 0.0) return false;
    return true;
}

Meaning meaning_of(Rule rule) {
    return rule == Rule::Naive              ? Meaning::Naive
           : rule == Rule::InverseTranspose ? Meaning::InverseTranspose
                                            : Meaning::Cofactor;
}

// "= −0.750 ✗", or "= —" where there is no normal. One tangent alone does not make a plane.
MathBox dot_with_verdict(const MathStyle& style, const RuleCheck& check, std::size_t tangent) {
    const auto &dot = check.dots[tangent], &other = check.dots[1 - tangent];
    if (!dot) return written(style, style.upright, "\u2014", Ink::Dim);
    MathBox box = value_box(style, *dot, Ink::Plain);
    box.add({}, written(style, style.upright, "\u22120.000", Ink::Plain).width);  // so that the mark stands still
    const bool zero = is_zero(*dot), both = zero && (!other || is_zero(*other));
    const char* const verdict = both ? "✓ perpendicular" : zero ? "✗ only to this one" : "✗ not perpendicular";
    box.append(written(style, style.script, verdict, both ? Ink::Good : Ink::Bad), std::round(0.5f * style.em));
    return box;
}

std::string about(const RuleCheck& check, std::size_t tangent) {
    const auto& other = check.dots[1 - tangent];
    std::string with_other;
    if (other)
        with_other = "; with the other tangent " + (is_zero(*other) ? "0" : fixed_unless_small(other->clean(0, 0)));
    switch (check.rule) {
        case Rule::Naive:
            return check.normal ? "the naive rule, n_naive = M₃ n_obj" + with_other
                                : "the naive rule: M₃ n_obj is 0 here, which has no direction";
        case Rule::InverseTranspose:
            return check.normal ? "the inverse transpose, n_world = (M₃⁻¹)ᵀ n_obj" + with_other
                                : "the inverse transpose does not exist, as M₃ has no inverse, and the cofactor’s is 0";
        case Rule::Cofactor: break;
    }
    return "the cofactor rule, n_world = cof(M₃) n_obj, the only one that gives a normal here" + with_other;
}

// How the cofactor's normal lies to the true one; nothing where it is the true one, or where there is none.
std::string about_cofactor(const Derivation& derivation) {
    const auto& truth = derivation.checks[Rule::InverseTranspose].normal;
    const auto& cofactor = derivation.checks[Rule::Cofactor].normal;
    if (!truth || !cofactor || !derivation.affine) return {};
    const auto same = product(transpose(*cofactor), *truth);
    if (same && (*same)(0, 0) < 0.0)
        return "The cofactor’s, cof(M₃) n_obj, is perpendicular, too, and points the other way.";
    return "The cofactor’s, cof(M₃) n_obj, has the same direction, and is det(M₃) times as long.";
}

MathBox how_far_off(const MathStyle& style, const RuleCheck& naive, bool any_truth, float width) {
    if (!naive.degrees_off)
        return paragraph(style,
                         any_truth ? "M₃ n_obj is 0: there is no naive normal."
                                   : "No rule gives a normal here, so there is nothing to compare with.",
                         width, Ink::Plain, Meaning::InverseTranspose);
    MathBox box = written(style, style.upright, in_degrees(naive.degrees_off), Ink::Naive);
    box.append(written(style, style.script,
                       *naive.degrees_off < 5e-4 ? "off: the naive normal is right here"
                                                 : "is how far the naive normal is off",
                       Ink::Plain),
               std::round(0.4f * style.em));
    return box;
}

// What is not a symbol of the derivation.
MathBox letter(const MathStyle& style, const char* letter, const char* subscript, Ink ink) {
    MathBox box = written(style, style.letters, letter, ink);
    return *subscript ? with_subscript(style, std::move(box), subscript, ink) : box;
}
MathBox digit(const MathStyle& style, const char* digit, Ink ink) { return written(style, style.upright, digit, ink); }

void add_part(const MathStyle& style, MathBox& box, Expression::Kind kind, Symbol symbol, bool as_number) {
    const float more = std::round(0.1f * style.em);
    box.parts.push_back({{-more, -box.ascent - more},
                         {box.width + more, box.descent + more},
                         1,
                         kind,
                         symbol,
                         Meaning::Tangent,
                         as_number,
                         true});
}

// M on a point or a vector, in blocks: [M3 t; 0 1] [v; 0].
Equation in_blocks(const MathStyle& style, bool vector) {
    const Ink ink = vector ? Ink::Tangent : Ink::Plain;
    const char* name = vector ? "v" : "p";
    const char* w = vector ? "0" : "1";
    MathBox t = letter(style, "t", "", vector ? Ink::Faint : Ink::Plain);
    if (vector) strike(style, t, Ink::Dim);
    MathBox moved = name_box(style, Symbol::M3, Meaning::Plain);
    moved.append(letter(style, name, "obj", ink), std::round(0.16f * style.em));
    if (!vector) {
        moved.append(digit(style, "+", Ink::Plain), std::round(0.2f * style.em));
        moved.append(letter(style, "t", "", Ink::Plain), std::round(0.2f * style.em));
    }
    Equation e;
    e.left = bracketed_cells(
        style,
        {{name_box(style, Symbol::M3, Meaning::Plain), t}, {digit(style, "0", Ink::Dim), digit(style, "1", Ink::Dim)}},
        Ink::Plain);
    MathBox before = bracketed_cells(style, {{letter(style, name, "obj", ink)}, {digit(style, w, Ink::Plain)}}, ink);
    if (vector) add_part(style, before, Expression::Kind::Symbol, Symbol::VObject, false);
    e.left.append(before, std::round(0.16f * style.em));
    e.right = bracketed_cells(style, {{moved}, {digit(style, w, Ink::Plain)}}, ink);
    if (vector) add_part(style, e.right, Expression::Kind::Symbol, Symbol::VWorld, false);
    return e;
}

// A point's place as far as it matters beside its w, which is 1: what rounding left of 0 is not shown as 10⁻¹⁶.
Value beside_w(Value v) {
    double largest = 0.0;
    for (int r = 0; r < v.rows; ++r) largest = std::max(largest, std::abs(v(r, 0)));
    for (double& error : v.error) error = std::max(error, 1e-14 * largest);
    return v;
}

Equation in_numbers(const MathStyle& style, const HomogeneousDemo& demo, bool vector) {
    const std::size_t i = vector ? 1 : 0;
    const Ink ink = vector ? Ink::Tangent : Ink::Plain;
    const auto entry = [&](int r, int c) {
        return vector && c == 3 && r < 3 ? Ink::Faint : r == 3 ? Ink::Dim : Ink::Plain;
    };
    Equation e;
    e.left = value_box(style, demo.m, entry, Ink::Plain, vector ? 3 : -1);
    MathBox before = value_box(style, beside_w(*demo.before[i]), ink),
            after = value_box(style, beside_w(*demo.after[i]), ink);
    if (vector) add_part(style, before, Expression::Kind::Symbol, Symbol::VObject, true);
    if (vector) add_part(style, after, Expression::Kind::Symbol, Symbol::VWorld, true);
    e.left.append(before, std::round(0.16f * style.em));
    e.right = after;
    return e;
}

}  // namespace

Passage check_passage(const Look& look, const Derivation& derivation, const NamesOrNumbers& shown, std::size_t tangent,
                      std::size_t first_line, float width) {
    Passage passage{.title = "The check: which one is perpendicular?", .state = Step::State::Holds, .rows = {}};
    const Rule by = derivation.n_world_by.value_or(Rule::InverseTranspose);
    const std::array<const RuleCheck*, 2> checks{&derivation.checks[0], &derivation.checks[by]};
    const auto& v_world = derivation.steps[1].left().operands[1];  // of n_world · v_world = 0
    const auto equation = [&](const MathStyle& at, std::size_t i) {
        const RuleCheck& check = *checks[i];
        const Expression e = dot(symbol(Symbol::NWorld, meaning_of(check.rule), check.normal), v_world);
        MathBox left = expression_box(at, e, [&](Place place, const Expression& part) {
            return shown.number(first_line + i, place, part.kind == Expression::Kind::Symbol);
        });
        return Equation{std::move(left), dot_with_verdict(at, check, tangent)};
    };
    auto equations = fitted(look, checks.size(), equation, width);
    const MathStyle style = math_style(look);
    for (std::size_t i = 0; i < checks.size(); ++i) {
        passage.rows.push_back({std::move(equations[i].box), first_line + i, i == 0 ? 0.0f : look.px(10)});
        passage.rows.push_back(
            {paragraph(style, about(*checks[i], tangent), width, Ink::Dim, meaning_of(by)), 0, look.px(6)});
    }
    passage.rows.push_back({how_far_off(style, *checks[0], derivation.n_world_by.has_value(), width), 0, look.px(12)});
    if (!derivation.affine)
        passage.rows.push_back(
            {paragraph(style,
                       "M is not affine, and neither rule is right. The normal is that of the tangent "
                       "plane’s image, the dark arrow at the probe.",
                       width, Ink::Plain, Meaning::InverseTranspose),
             0, look.px(6)});
    if (const std::string more = about_cofactor(derivation); !more.empty())
        passage.rows.push_back({paragraph(style, more, width, Ink::Dim, meaning_of(by)), 0, look.px(6)});
    return passage;
}

Passage homogeneous_passage(const Look& look, const Derivation& derivation, const NamesOrNumbers& shown,
                            std::size_t first_line, float width) {
    const HomogeneousDemo& demo = derivation.homogeneous;
    const bool affine = demo.m.clean(3, 0) == 0.0 && demo.m.clean(3, 1) == 0.0 && demo.m.clean(3, 2) == 0.0 &&
                        demo.m.clean(3, 3) == 1.0;
    Passage passage{.title = "Why only M₃ counts: w = 0", .state = Step::State::Holds, .rows = {}};
    const auto equation = [&](const MathStyle& at, std::size_t i) {
        const bool has_number = demo.before[i] && demo.after[i];
        const bool number = has_number && (!affine || shown.number(first_line + i, 1, true));
        Equation e = number ? in_numbers(at, demo, i == 1) : in_blocks(at, i == 1);
        if (has_number) {
            add_part(at, e.left, Expression::Kind::Product, Symbol::Zero, number);
            add_part(at, e.right, Expression::Kind::Product, Symbol::Zero, number);
        }
        return e;
    };
    auto equations = fitted(look, 2, equation, width);
    const MathStyle style = math_style(look);
    static constexpr const char* kAbout[2] = {
        "a point has w = 1, and the translation t, the last column of M, is added once",
        "a vector has w = 0, and the translation drops out"};
    for (std::size_t i = 0; i < 2; ++i) {
        passage.rows.push_back({std::move(equations[i].box), first_line + i, i == 0 ? 0.0f : look.px(12)});
        if (affine)
            passage.rows.push_back(
                {paragraph(style, kAbout[i], width, Ink::Dim, Meaning::InverseTranspose), 0, look.px(6)});
    }
    passage.rows.push_back(
        {paragraph(style, demo.reason, width, Ink::Plain, Meaning::InverseTranspose), 0, look.px(10)});
    return passage;
}

}  // namespace normalscope

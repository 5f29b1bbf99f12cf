// The explanation for a terminal.

#include "core/explain/explanation.h"
#include "core/explain/text_box.h"
#include "core/formula/print.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace normalscope {

namespace {

constexpr std::size_t kWidth = 96, kIndent = 5, kReasonColumn = 41;
constexpr std::size_t kMostPieces = 600;  // of a formula; nobody reads more

std::string degrees_text(double degrees) { return number_text(degrees, 1e-7, 3) + "°"; }
std::string degrees_text(const std::optional<double>& degrees) { return degrees ? degrees_text(*degrees) : "–"; }

// An angle that may be far below a thousandth of a degree.
std::string degrees_off(double degrees) { return number_text(degrees, 0.0, 3) + "°"; }

std::string heading(const std::string& title) {
    std::string line = "\n── " + title + " ";
    for (std::size_t i = columns(line); i < kWidth; ++i) line += "─";
    return line + "\n\n";
}

std::string paragraph(std::string_view text, std::size_t indent = 0) {
    return indented(wrapped(text, kWidth - indent), indent);
}

// An expression in numbers; names where there is no number.
TextBox numbers_box(const Expression& e, int decimals) {
    using enum Expression::Kind;
    const auto operand = [&](std::size_t i) {
        const TextBox box = numbers_box(e.operands[i], decimals);
        return needs_parentheses(e.operands[i], e.kind) ? in_parentheses(box) : box;
    };
    switch (e.kind) {
        case Symbol: return e.value ? matrix_box(*e.value, decimals) : text_box(expression_text(e));
        case Transpose:
            // A vector lies down rather than wear a mark.
            if (e.operands[0].kind == Symbol && e.value && (e.value->rows == 1 || e.value->columns == 1))
                return matrix_box(*e.value, decimals);
            return superscript(operand(0), "ᵀ");
        case Inverse: return superscript(operand(0), "⁻¹");
        case Dot: return beside({operand(0), operand(1)}, " · ");
        case Equals: return beside({operand(0), operand(1)}, "  =  ");
        case Product: break;
    }
    std::vector<TextBox> factors;
    for (std::size_t i = 0; i < e.operands.size(); ++i) factors.push_back(operand(i));
    return beside(factors);
}

// Side by side as far as they fit, the rest below.
std::string flowing(const std::vector<TextBox>& boxes, std::size_t indent) {
    std::string out;
    TextBox row = boxes.front();
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        if (indent + row.width + 3 + boxes[i].width <= kWidth) {
            row = beside({row, boxes[i]}, "   ");
            continue;
        }
        out += indented(row.lines, indent) + "\n";
        row = boxes[i];
    }
    return out + indented(row.lines, indent);
}

std::string beside_reason(const std::string& line, const std::string& reason) {
    std::vector<std::string> reasons = wrapped(reason, kWidth - kReasonColumn - 2);
    std::vector<std::string> lines;
    if (columns(line) >= kReasonColumn) lines.push_back(line);
    for (std::size_t i = 0; i < reasons.size(); ++i)
        lines.push_back(padded(i == 0 && lines.empty() ? line : "", kReasonColumn) + reasons[i]);
    return indented(lines, 2);
}

std::string of_matrix(const Explanation& e) {
    const std::string facts = "   det " + number_text(e.matrices.determinant, 0.0, 4) + " · rank " +
                              std::to_string(e.matrices.rank) + " · condition " +
                              (e.claims.condition ? number_text(*e.claims.condition, 0.0, 4) : "–");
    std::string out = indented(beside({text_box("M ="), matrix_box(e.m), text_box(facts)}).lines, 2);
    for (const std::string& note : e.notes) out += "\n" + paragraph(note, 2);
    if (!e.probe) return out;
    const auto vector = [](const auto& v) { return matrix_box(value_of(v.xyz)); };
    return out + "\nAt the probe, in object space:\n\n" +
           indented(beside({text_box("point"), vector(e.probe->point), text_box("  n_obj"), vector(e.probe->normal),
                            text_box("  tangents"), vector(e.probe->tangents[0]), vector(e.probe->tangents[1])})
                        .lines,
                    2);
}

// "(0.94, 0.684, 1.6275)"; dashes for what does not exist.
std::string vector_text(const glm::dvec3& v) {
    std::string text;
    for (glm::length_t i = 0; i < 3; ++i)
        text += (i > 0 ? ", " : "(") + (std::isfinite(v[i]) ? number_text(v[i]) : "–");
    return text + ")";
}

// What a formula is written as, a long one over several lines.
std::string expression_lines(std::string_view name, const formulas::Formula& formula, formulas::Id id) {
    const std::vector<formulas::Piece> pieces = formulas::pieces(formula.graph, id, kMostPieces);
    const std::string text = pieces.back().kind == formulas::Piece::Kind::Truncated ? "too long to be written here"
                                                                                    : formulas::to_unicode(pieces);
    const std::string head = padded(name, 10) + " = ";
    std::vector<std::string> lines = wrapped(text, kWidth - columns(head) - 2);
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = (i == 0 ? head : padded("", columns(head))) + lines[i];
    return indented(lines, 2);
}

std::string of_gradient(const Explanation& e) {
    if (!e.implicit) return "";
    const formulas::Formula& formula = e.implicit->formula();
    std::string out = heading("The normal is the gradient: ∇f = (∂f/∂x, ∂f/∂y, ∂f/∂z)");
    for (std::size_t i = 0; i < kFormulaNames.size(); ++i)
        out += expression_lines(kFormulaNames[i], formula, formula.expressions()[i]);
    std::string values;
    for (const char letter : formula.parameters)
        values += (values.empty() ? "where " : ", ") + std::string(1, letter) + " = " +
                  number_text(e.implicit->source().parameters[formulas::kParameterNames.find(letter)]);
    if (!values.empty()) out += "\n" + paragraph(values, 2);
    if (!e.gradient) return out;
    const GradientReport& g = *e.gradient;
    const std::string gradient = g.gradient
                                     ? ",  ∇f = " + vector_text(*g.gradient) + ",  |∇f| = " + number_text(g.length)
                                     : "; ∇f does not exist";
    out += "\nAt the probe:\n\n" + indented({"f = " + number_text(g.f) + gradient}, 2);
    const auto row = [](std::string_view what, const glm::dvec3& v, const std::optional<double>& off) {
        return indented({padded(what, 39) + padded(vector_text(v), 34) + (off ? degrees_off(*off) : "–")}, 2);
    };
    out += "\n  " + padded("the normal", 73) + "off by\n";
    out += g.normal ? row("∇f / |∇f|, exactly", g.normal->xyz, 0.0)
                    : indented({"∇f / |∇f|: no normal here, since ∇f is zero or does not exist"}, 2);
    out += row("differences of f, h = " + number_text(g.step), g.differences.direction(), g.differences.degrees_off);
    if (g.polygon) out += row("a triangle's cross product", g.polygon->vector, g.polygon->degrees_off);
    return out;
}

std::string of_derivation(const Explanation& e) {
    std::string out = heading("Why the inverse transpose?");
    int number = 0;
    for (const Step& step : e.derivation.steps) {
        const std::string label = padded(std::to_string(++number) + ".", 4);
        out += (number > 1 ? "\n" : "") + beside_reason(label + expression_text(step.line), step.reason);
        if (step.state != Step::State::NoValue) {
            TextBox box = numbers_box(step.line, 4);
            for (int decimals = 3; decimals > 1 && box.width + kIndent + 5 > kWidth; --decimals)
                box = numbers_box(step.line, decimals);
            box = beside(box, text_box(step.state == Step::State::Holds ? "   ✓" : "   ✗"));
            out += "\n" + indented(box.lines, kIndent + 1);
        }
        if (!step.remark.empty()) out += "\n" + paragraph(step.remark, kIndent + 1);
    }
    return out;
}

std::string of_checks(const Explanation& e) {
    std::string out = heading("The check");
    out += "  " + padded("rule", 20) + padded("n_world", 34) + padded("n_world · v_world", 24) + "off by\n";
    for (const RuleCheck& check : e.derivation.checks) {
        std::string line = padded(name(check.rule), 20);
        if (!check.normal) {
            line += !e.probe ? "–" : check.rule == Rule::InverseTranspose ? "does not exist" : "zero: no normal";
        } else {
            std::string normal, dots;
            for (int i = 0; i < 3; ++i) normal += (i > 0 ? ", " : "(") + number_text(*check.normal, i, 0);
            for (std::size_t k = 0; k < 2; ++k)
                dots += (k > 0 ? ", " : "") + (check.dots[k] ? number_text(*check.dots[k], 0, 0) : "–");
            line += padded(normal + ")", 34) + padded(dots, 24) + degrees_text(check.degrees_off);
        }
        out += indented({line}, 2);
    }
    if (!e.affine && e.derivation.n_world) {
        const Value& n = *e.derivation.n_world;
        out += "\n" +
               paragraph("No rule is right under this M. The normal, by the image of the tangent plane: (" +
                             number_text(n, 0, 0) + ", " + number_text(n, 1, 0) + ", " + number_text(n, 2, 0) + ").",
                         2);
    }
    if (!e.claims.worst_degrees) return out;
    return out + "\n" +
           paragraph(e.claims.naive_direction_right.value_or(false)
                         ? "The naive rule has the right direction for every normal under this M."
                         : "For some normal, somewhere, the naive rule is off by as much as " +
                               degrees_text(e.claims.worst_degrees) + " under this M.",
                     2);
}

std::string of_homogeneous(const HomogeneousDemo& demo) {
    std::string out = heading("Why translation drops out: w = 0");
    out += paragraph(demo.reason, 2);
    constexpr std::array<std::string_view, 2> kKinds{"a point, w = 1   ", "a vector, w = 0  "};
    for (std::size_t i = 0; i < 2; ++i)
        if (demo.before[i] && demo.after[i])
            out += "\n" + flowing({beside({text_box(kKinds[i]), matrix_box(demo.m), matrix_box(*demo.before[i])}),
                                   beside({text_box("="), matrix_box(*demo.after[i])})},
                                  2);
    return out;
}

TextBox named(const std::string& name, const std::optional<Value>& value) {
    return beside({text_box(name + " ="), value ? matrix_box(*value) : text_box("none")});
}

std::string of_stack(const Explanation& e) {
    std::string out = heading("The stack: the composite of the inverses, instead of the inverse of the composite");
    if (e.stack.empty()) return out + "  empty: M = I\n";
    int number = 0;
    for (const EntryAlgebra& entry : e.stack) {
        ++number;
        out += "\n" + indented({std::to_string(number) + ". " + entry.kind}, 2) + "\n";
        out += flowing({named("A", entry.a), named("A₃⁻¹", entry.inverse), named("(A₃⁻¹)ᵀ", entry.inverse_transpose)},
                       kIndent);
        for (const std::string& observation : entry.observations) out += "\n" + paragraph(observation, kIndent);
        if (number > 1)
            out += "\n" +
                   paragraph("The products so far: M; the (A₃⁻¹)ᵀ of the entries; (M₃⁻¹)ᵀ of the product.", kIndent) +
                   "\n" +
                   flowing({named("M", entry.product), named("∏ (A₃⁻¹)ᵀ", entry.composite),
                            named("(M₃⁻¹)ᵀ", entry.inverted_product)},
                           kIndent);
    }
    const EntryAlgebra& last = e.stack.back();
    out += "\n  The composite of the inverses, transposed, and the inverse of the composite, transposed:\n\n";
    out += flowing({named("∏ (A₃⁻¹)ᵀ", last.composite), named("(M₃⁻¹)ᵀ", last.inverted_product)}, 2);
    if (!last.apart) return out;
    // Rounding alone parts them by the digits that the inverse loses.
    const double rounding = 1e-15 * (1.0 + number) * e.claims.condition.value_or(1.0);
    return out + "\n" +
           paragraph(
               last.apart->relative <= rounding ? "They are the same but for rounding."
               : !e.affine
                   ? "They differ, since M is not affine: the 3×3 part of a product is then not the product of the 3×3 "
                     "parts."
                   : "They are " + number_text(last.apart->relative, 0.0, 2) +
                         " of their largest entry apart: rounding, amplified by entries that are nearly singular.",
               2);
}

std::string of_orders(const Explanation& e) {
    if (e.orders.empty()) return "";
    std::string out = heading("The wrong orders, and how far they turn the probe's normal");
    for (const OrderOfInverses& order : e.orders) {
        const std::string off = order.degrees_off ? degrees_text(*order.degrees_off) : order.matrix ? "–" : "none";
        const std::string mark = !order.matrix || !order.degrees_off ? " "
                                 : *order.degrees_off < 1e-6         ? (order.is_right ? "✓" : "≈")
                                                                     : "✗";
        out += beside_reason(padded(order.formula, 27) + mark + " " + off, order.reason);
    }
    return out;
}

std::string of_decomposition(const Decomposition& d) {
    std::string out = heading("M₃ = R S: a stretch, then a rotation; only the stretch hurts normals");
    out += flowing({named("R", value_of(d.rotation)), named("S", value_of(d.stretch))}, 2);
    const auto vector = [](const glm::dvec3& v) {
        const Value value = value_of(v);
        return "(" + number_text(value, 0, 0) + ", " + number_text(value, 1, 0) + ", " + number_text(value, 2, 0) + ")";
    };
    out += "\n" +
           paragraph(
               "R turns by " + degrees_text(d.degrees) + (d.degrees > 0.0 ? " about " + vector(d.axis) : "") +
                   (d.reflects ? ", after a mirror image in the plane perpendicular to " + vector(d.axis) + "." : ".") +
                   (d.unique ? "" : " Other rotations would serve as well, since M₃ has no inverse."),
               2);
    for (const StretchAxis& axis : d.axes)
        out += indented({"S stretches " + padded(vector(axis.from.xyz), 28) + " by " + number_text(axis.factor) +
                         (axis.unique ? "" : "   (one choice of several)")},
                        2);
    if (d.worst && d.worst->degrees > 1e-7)
        out += "\n" +
               paragraph("Worst halfway between the largest and the smallest, as at " + vector(d.worst->object[0].xyz) +
                             ": " + degrees_text(d.worst->degrees) + " off (atan k − atan 1/k).",
                         2);
    return out;
}

std::string of_classes(const Explanation& e) {
    std::string out = heading("Classes of maps: ● marks those that M belongs to; the others are shown by an example");
    const auto yes_no = [](const std::optional<bool>& b) { return std::string(!b ? "–" : *b ? "yes" : "no"); };
    out += "    " + padded("class", 15) + padded("defined by", 26) + padded("direction", 11) + padded("length", 9) +
           padded("inverse", 9) + "cofactor\n";
    for (const MapClassRow& row : e.classes)
        out += indented(
            {std::string(row.contains_m ? "● " : "  ") + padded(name(row.map_class), 15) +
             padded(meaning(row.map_class), 25) + padded(yes_no(row.claims.naive_direction_right), 11) +
             padded(yes_no(row.claims.naive_length_right), 8) +
             padded(row.claims.inverse_transpose_exists ? "yes" : "no", 9) + std::string(name(row.claims.cofactor))},
            2);
    out += "\n" +
           paragraph(
               "direction, length: does M₃ n have the right one, for every n? inverse: does (M₃⁻¹)ᵀ exist? cofactor: "
               "what cof(M₃) n is, compared with (M₃⁻¹)ᵀ n. A map that is not affine acts differently at every point.",
               2);
    if (e.claims.digits_lost)
        out += "\n" +
               paragraph("How sure: condition number " + number_text(*e.claims.condition, 0.0, 4) +
                             "; the inverse keeps about " +
                             std::to_string(std::max(0, static_cast<int>(std::lround(16.0 - *e.claims.digits_lost)))) +
                             " of 16 digits.",
                         2);
    return out;
}

}  // namespace

std::string explanation_text(const Explanation& e) {
    std::string out = e.about.empty() ? "" : paragraph(e.about) + "\n";
    out += of_matrix(e) + of_gradient(e) + of_derivation(e) + of_checks(e) + of_homogeneous(e.derivation.homogeneous) +
           of_stack(e) + of_orders(e) + of_decomposition(e.decomposition) + of_classes(e);
    return out + "\n" +
           paragraph(
               "Numbers no larger than their rounding error (first order; 4ε of a matrix's largest entries) are "
               "printed as 0.");
}

}  // namespace normalscope

// The explanation as a document: article and amsmath; color for the colours, geometry for the margins.

#include "core/explain/explanation.h"
#include "core/explain/latex.h"
#include "core/formula/print.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace normalscope {

namespace {

std::string degrees(double d) { return "$" + latex_number(d, 1e-7, 3) + "{}^\\circ$"; }
std::string degrees(const std::optional<double>& d) { return d ? degrees(*d) : "--"; }

std::string in_color(std::string_view color, const std::string& text) {
    return "{\\color{" + std::string(color) + "}" + text + "}";
}
std::string_view color(Rule rule) {
    constexpr std::array<std::string_view, 3> kColors{"naive", "inversetranspose", "cofactor"};
    return kColors.at(static_cast<std::size_t>(rule));
}

std::string display(const std::string& mathematics) { return "\\[ " + mathematics + " \\]\n"; }

std::string color_definitions() {
    std::string out;
    const auto define = [&](std::string_view name, const glm::vec3& c) {
        out += "\\definecolor{" + std::string(name) + "}{rgb}{" + latex_color(c) + "}\n";
    };
    for (const Rule rule : kRules) define(color(rule), rule_color(rule));
    define("tangent", kTangentColor);
    define("object", theme_colors(Theme::Light).ghost);
    return out;
}

std::string preamble(const Explanation& e) {
    std::string out =
        "\\documentclass[11pt,a4paper]{article}\n\\usepackage[utf8]{inputenc}\n"
        "\\usepackage{amsmath}\n\\usepackage{color}\n\\usepackage[margin=22mm]{geometry}\n\\setlength{\\parindent}{"
        "0pt}\n"
        "\\setlength{\\parskip}{4pt}\n";
    out += color_definitions();
    return out + "\\begin{document}\n\n\\section*{Why the inverse transpose?}\n" + latex_text(e.about) + "\n";
}

std::string of_matrix(const Explanation& e) {
    std::string out =
        display("M = " + latex_matrix(e.m) + " \\qquad \\det M_3 = " + latex_number(e.matrices.determinant) +
                ", \\quad \\text{rank } " + std::to_string(e.matrices.rank) + ", \\quad \\text{condition } " +
                (e.claims.condition ? latex_number(*e.claims.condition) : "\\text{--}"));
    for (const std::string& note : e.notes) out += latex_text(note) + "\n\n";
    return out;
}

std::string vector(const glm::dvec3& v) {
    std::string text;
    for (glm::length_t i = 0; i < 3; ++i)
        text += (i > 0 ? ",\\; " : "(") + (std::isfinite(v[i]) ? latex_number(v[i]) : "\\text{--}");
    return "$" + text + ")$";
}

std::string of_gradient(const Explanation& e) {
    if (!e.implicit) return "";
    constexpr std::size_t kMostPieces = 600;
    constexpr std::array<std::string_view, 4> kNames{"f(x, y, z)", "\\frac{\\partial f}{\\partial x}",
                                                     "\\frac{\\partial f}{\\partial y}",
                                                     "\\frac{\\partial f}{\\partial z}"};
    const formulas::Formula& formula = e.implicit->formula();
    // Inline, since TeX breaks such lines by itself.
    std::string out = "\\subsection*{The normal is the gradient}\n{\\sloppy\n";
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const std::vector<formulas::Piece> pieces =
            formulas::pieces(formula.graph, formula.expressions()[i], kMostPieces);
        const bool whole = pieces.back().kind != formulas::Piece::Kind::Truncated;
        out += "$\\displaystyle " + std::string(kNames[i]) + " = " +
               (whole ? formulas::to_latex(pieces) : "\\text{(too long to be written here)}") + "$\n\n";
    }
    out += "}\n";
    for (const char letter : formula.parameters)
        out += "$" + std::string(1, letter) + " = " +
               latex_number(e.implicit->source().parameters[formulas::kParameterNames.find(letter)]) + "$\n\n";
    if (!e.gradient) return out;
    const GradientReport& g = *e.gradient;
    out += "At the probe $f = " + latex_number(g.f) + "$" +
           (g.gradient ? ", $\\nabla f = {}$" + vector(*g.gradient) + ", $|\\nabla f| = " + latex_number(g.length) + "$"
                       : "; $\\nabla f$ does not exist") +
           ".\n\n\\begin{tabular}{llr}\n & normal & off by \\\\ \\hline\n";
    const auto row = [](const std::string& what, const glm::dvec3& v, const std::optional<double>& off) {
        return what + " & " + vector(v) + " & " + (off ? "$" + latex_number(*off, 0.0, 3) + "{}^\\circ$" : "--") +
               " \\\\\n";
    };
    out += g.normal ? row("$\\nabla f / |\\nabla f|$", g.normal->xyz, 0.0)
                    : "$\\nabla f / |\\nabla f|$ & no normal: $\\nabla f$ is zero or does not exist & \\\\\n";
    out += row("differences of $f$, $h = " + latex_number(g.step) + "$", g.differences.direction(),
               g.differences.degrees_off);
    if (g.polygon) out += row("a triangle's cross product", g.polygon->vector, g.polygon->degrees_off);
    return out + "\\end{tabular}\n\n";
}

std::string of_derivation(const Explanation& e) {
    std::string out = "\\subsection*{The derivation}\n";
    int number = 0;
    for (const Step& step : e.derivation.steps) {
        out += "\\textbf{" + std::to_string(++number) + ".} $" + latex_names(step.line) +
               "$ \\hfill \\begin{minipage}[t]{0.58\\textwidth}\\small " + latex_text(step.reason) +
               "\\end{minipage}\n\n";
        if (step.state != Step::State::NoValue)
            out += "{\\small" +
                   display(latex_numbers(step.line) +
                           (step.state == Step::State::Holds ? "" : " \\quad\\text{does not hold}")) +
                   "}\n";
        if (!step.remark.empty()) out += "\\emph{" + latex_text(step.remark) + "}\n\n";
    }
    return out;
}

std::string of_checks(const Explanation& e) {
    std::string out =
        "\\subsection*{The check}\n\\begin{tabular}{lllr}\n rule & $n_\\mathrm{world}$ & $n_\\mathrm{world}\\cdot "
        "v_\\mathrm{world}$ & off by \\\\ \\hline\n";
    for (const RuleCheck& check : e.derivation.checks) {
        std::string row = in_color(color(check.rule), std::string(name(check.rule)));
        if (check.normal) {
            row += " & $(";
            for (int i = 0; i < 3; ++i)
                row += (i > 0 ? ",\\; " : "") +
                       latex_number((*check.normal)(i, 0), check.normal->error[static_cast<std::size_t>(i)]);
            row += ")$ & $";
            for (std::size_t k = 0; k < 2; ++k)
                row += (k > 0 ? ",\\; " : "") +
                       (check.dots[k] ? latex_number((*check.dots[k])(0, 0), check.dots[k]->error[0]) : "\\text{--}");
            row += "$ & " + degrees(check.degrees_off);
        } else {
            row += check.rule == Rule::InverseTranspose ? " & does not exist & & " : " & zero: no normal & & ";
        }
        out += row + " \\\\\n";
    }
    out += "\\end{tabular}\n\n";
    if (!e.affine && e.derivation.n_world)
        out += "No rule is right under this $M$. The normal, by the image of the tangent plane: $" +
               latex_matrix(transpose(*e.derivation.n_world)) + "$.\n\n";
    if (e.claims.naive_direction_right.value_or(false))
        out += "The naive rule has the right direction for every normal under this $M$.\n\n";
    else if (e.claims.worst_degrees)
        out += "For some normal, somewhere, the naive rule is off by as much as " + degrees(e.claims.worst_degrees) +
               " under this $M$.\n\n";
    return out;
}

std::string of_homogeneous(const HomogeneousDemo& demo) {
    std::string out = "\\subsection*{Why translation drops out: $w = 0$}\n" + latex_text(demo.reason) + "\n";
    for (std::size_t i = 0; i < 2; ++i)
        if (demo.before[i] && demo.after[i])
            out += display((i == 0 ? "\\text{a point: } " : "\\text{a vector: } ") + latex_matrix(demo.m) +
                           latex_matrix(*demo.before[i]) + " = " + latex_matrix(*demo.after[i]));
    return out;
}

std::string named(const std::string& name, const std::optional<Value>& value) {
    return name + " = " + (value ? latex_matrix(*value) : "\\text{none}");
}

std::string of_stack(const Explanation& e) {
    std::string out = "\\subsection*{The stack}\n";
    if (e.stack.empty()) return out + "Empty: $M = I$.\n\n";
    int number = 0;
    for (const EntryAlgebra& entry : e.stack) {
        out += "\\textbf{" + std::to_string(++number) + ".} " + entry.kind + "\n";
        out += "{\\small" +
               display(named("A", entry.a) + " \\quad " + named("A_3^{-1}", entry.inverse) + " \\quad " +
                       named("(A_3^{-1})^{\\mathsf T}", entry.inverse_transpose)) +
               "}\n";
        for (const std::string& observation : entry.observations) out += latex_text(observation) + "\n\n";
    }
    const EntryAlgebra& last = e.stack.back();
    out +=
        display(named("\\text{composite of the inverses: } \\textstyle\\prod (A_3^{-1})^{\\mathsf T}", last.composite));
    out += display(named("\\text{inverse of the composite: } (M_3^{-1})^{\\mathsf T}", last.inverted_product));
    if (last.apart)
        out +=
            last.apart->relative <= 1e-14 ? "They are the same but for rounding.\n\n"
            : !e.affine
                ? "They differ, since $M$ is not affine: the $3\\times3$ part of a product is then not the product of "
                  "the $3\\times3$ parts.\n\n"
                : "They are $" + latex_number(last.apart->relative, 0.0, 2) + "$ apart, of the largest entry.\n\n";
    out += "\\subsection*{The wrong orders}\n\\begin{tabular}{lrp{0.45\\textwidth}}\n";
    for (const OrderOfInverses& order : e.orders)
        out += latex_text(order.formula) + " & " + (order.matrix ? degrees(order.degrees_off) : "none") +
               " & \\small " + latex_text(order.reason) + " \\\\\n";
    return out + "\\end{tabular}\n\n";
}

std::string of_decomposition(const Decomposition& d) {
    const auto vector = [](const glm::dvec3& v) { return "$" + latex_matrix(transpose(value_of(v))) + "$"; };
    std::string out = "\\subsection*{$M_3 = R\\,S$: a stretch, then a rotation; only the stretch hurts normals}\n";
    out += display(named("R", value_of(d.rotation)) + " \\qquad " + named("S", value_of(d.stretch)));
    out += "$R$ turns by " + degrees(d.degrees) + (d.degrees > 0.0 ? " about " + vector(d.axis) : "") +
           (d.reflects ? ", after a mirror image in the plane perpendicular to " + vector(d.axis) + ".\n\n" : ".\n\n");
    for (const StretchAxis& axis : d.axes)
        out += "$S$ stretches " + vector(axis.from.xyz) + " by $" + latex_number(axis.factor) + "$" +
               (axis.unique ? "" : " (one choice of several)") + ".\n\n";
    if (d.worst && d.worst->degrees > 1e-7)
        out += "Worst halfway between the largest and the smallest: " + vector(d.worst->object[0].xyz) + ", " +
               degrees(d.worst->degrees) + " off, $\\arctan k - \\arctan \\frac1k$.\n\n";
    return out;
}

std::string of_classes(const Explanation& e) {
    const auto yes_no = [](const std::optional<bool>& b) { return std::string(!b ? "--" : *b ? "yes" : "no"); };
    std::string out =
        "\\subsection*{Classes of maps}\n$\\bullet$ is this $M$; the others are shown by an "
        "example.\n\n{\\small\\begin{tabular}{lllllll}\n & class & that is & direction & length & inverse & cofactor "
        "\\\\ "
        "\\hline\n";
    for (const MapClassRow& row : e.classes)
        out += std::string(row.contains_m ? "$\\bullet$" : "") + " & " + latex_text(name(row.map_class)) + " & " +
               latex_text(meaning(row.map_class)) + " & " + yes_no(row.claims.naive_direction_right) + " & " +
               yes_no(row.claims.naive_length_right) + " & " + (row.claims.inverse_transpose_exists ? "yes" : "no") +
               " & " + std::string(name(row.claims.cofactor)) + " \\\\\n";
    return out + "\\end{tabular}}\n\n";
}

}  // namespace

std::string explanation_latex(const Explanation& e) {
    return preamble(e) + of_matrix(e) + of_gradient(e) + of_derivation(e) + of_checks(e) +
           of_homogeneous(e.derivation.homogeneous) + of_stack(e) + of_decomposition(e.decomposition) + of_classes(e) +
           "\\end{document}\n";
}

std::string equations_latex(const Explanation& e) {
    std::string out = color_definitions() + "\\begin{align*}\n  M &= " + latex_matrix(e.m) + " \\\\\n";
    const auto aligned = [](std::string line) {
        if (const auto sign = line.find(" = "); sign != std::string::npos) line.replace(sign, 3, " &= ");
        return line;
    };
    for (const Step& step : e.derivation.steps) {
        if (step.id != "given" && step.id != "wanted" && step.id != "rule") continue;
        out += "  " + aligned(latex_names(step.line)) + " \\\\\n";
        if (step.id == "rule" && step.state != Step::State::NoValue)
            out += "  " + aligned(latex_numbers(step.line)) +
                   (step.state == Step::State::Fails ? " \\quad\\text{does not hold}" : "") + " \\\\\n";
    }
    out.resize(out.size() - 4);
    return out + "\n\\end{align*}\n";
}

}  // namespace normalscope

#include "core/explain/latex.h"

#include "core/base/decimal.h"

#include <array>
#include <cmath>
#include <utility>

namespace normalscope {

namespace {

std::string colored(Meaning meaning, const std::string& text) {
    constexpr std::array<std::string_view, 6> kColors{"", "object", "tangent", "naive", "inversetranspose", "cofactor"};
    const std::string_view color = kColors.at(static_cast<std::size_t>(meaning));
    return color.empty() ? text : "{\\color{" + std::string(color) + "}" + text + "}";
}

std::string symbol_name(Symbol symbol) {
    switch (symbol) {
        case Symbol::NObject: return "n_\\mathrm{obj}";
        case Symbol::VObject: return "v_\\mathrm{obj}";
        case Symbol::NWorld: return "n_\\mathrm{world}";
        case Symbol::VWorld: return "v_\\mathrm{world}";
        case Symbol::M3: return "M_3";
        case Symbol::Zero: break;
    }
    return "0";
}

std::string latex(const Expression& e, bool numbers) {
    using enum Expression::Kind;
    const auto operand = [&](std::size_t i) {
        const std::string text = latex(e.operands[i], numbers);
        return needs_parentheses(e.operands[i], e.kind) ? "\\left(" + text + "\\right)" : text;
    };
    switch (e.kind) {
        case Symbol: return colored(e.meaning, numbers && e.value ? latex_matrix(*e.value) : symbol_name(e.symbol));
        case Transpose:
            if (numbers && e.operands[0].kind == Symbol && e.value && e.value->rows == 1)
                return colored(e.meaning, latex_matrix(*e.value));
            return "{" + operand(0) + "}^{\\mathsf T}";
        case Inverse: return "{" + operand(0) + "}^{-1}";
        case Dot: return operand(0) + " \\cdot " + operand(1);
        case Equals: return operand(0) + " = " + operand(1);
        case Product: break;
    }
    std::string text = operand(0);
    for (std::size_t i = 1; i < e.operands.size(); ++i) text += " \\, " + operand(i);
    return text;
}

// What LaTeX reads otherwise, or has another name for.
constexpr std::array<std::pair<std::string_view, std::string_view>, 95> kSpecial{{
    {"n_obj", "$n_\\mathrm{obj}$"},
    {"v_obj", "$v_\\mathrm{obj}$"},
    {"n_world", "$n_\\mathrm{world}$"},
    {"v_world", "$v_\\mathrm{world}$"},
    {"\\", "\\textbackslash{}"},
    {"{", "\\{"},
    {"}", "\\}"},
    {"$", "\\$"},
    {"&", "\\&"},
    {"#", "\\#"},
    {"%", "\\%"},
    {"_", "\\_"},
    {"^", "\\textasciicircum{}"},
    {"~", "\\textasciitilde{}"},
    {"<", "$<$"},
    {">", "$>$"},
    {"|", "$|$"},
    {"\"", "''"},
    {"⁻¹", "$^{-1}$"},
    {"ᵀ", "$^{\\mathsf T}$"},
    {"⁻", "$^{-}$"},
    {"¹", "$^1$"},
    {"²", "$^2$"},
    {"³", "$^3$"},
    {"₃", "$_3$"},
    {"σ", "$\\sigma$"},
    {"ε", "$\\varepsilon$"},
    {"π", "$\\pi$"},
    {"α", "$\\alpha$"},
    {"β", "$\\beta$"},
    {"θ", "$\\theta$"},
    {"φ", "$\\varphi$"},
    {"λ", "$\\lambda$"},
    {"Σ", "$\\Sigma$"},
    {"Δ", "$\\Delta$"},
    {"γ", "$\\gamma$"},
    {"δ", "$\\delta$"},
    {"ζ", "$\\zeta$"},
    {"η", "$\\eta$"},
    {"ι", "$\\iota$"},
    {"κ", "$\\kappa$"},
    {"μ", "$\\mu$"},
    {"ν", "$\\nu$"},
    {"ξ", "$\\xi$"},
    {"ρ", "$\\rho$"},
    {"τ", "$\\tau$"},
    {"υ", "$\\upsilon$"},
    {"χ", "$\\chi$"},
    {"ψ", "$\\psi$"},
    {"ω", "$\\omega$"},
    {"Γ", "$\\Gamma$"},
    {"Θ", "$\\Theta$"},
    {"Λ", "$\\Lambda$"},
    {"Ξ", "$\\Xi$"},
    {"Π", "$\\Pi$"},
    {"Υ", "$\\Upsilon$"},
    {"Φ", "$\\Phi$"},
    {"Ψ", "$\\Psi$"},
    {"Ω", "$\\Omega$"},
    {"′", "$'$"},
    {"∘", "$\\circ$"},
    {"√", "$\\surd$"},
    {"∞", "$\\infty$"},
    {"⊥", "$\\perp$"},
    {"∥", "$\\parallel$"},
    {"∈", "$\\in$"},
    {"ᵖ", "$^p$"},
    {"₀", "$_0$"},
    {"₁", "$_1$"},
    {"₂", "$_2$"},
    {"∇", "$\\nabla$"},
    {"∂", "$\\partial$"},
    {"·", "$\\cdot$"},
    {"×", "$\\times$"},
    {"÷", "$\\div$"},
    {"Ð", "?"},
    {"ð", "?"},
    {"Þ", "?"},
    {"þ", "?"},
    {"−", "$-$"},
    {"±", "$\\pm$"},
    {"≠", "$\\ne$"},
    {"≤", "$\\le$"},
    {"≥", "$\\ge$"},
    {"≈", "$\\approx$"},
    {"→", "$\\to$"},
    {"°", "$^\\circ$"},
    {"½", "$\\frac12$"},
    {"…", "\\dots{}"},
    {"–", "--"},
    {"—", "---"},
    {"’", "'"},
    {"‘", "`"},
    {"“", "``"},
    {"”", "''"},
}};

}  // namespace

std::string latex_number(double number, double error, int decimals) {
    std::string text = number_text(number, error, decimals);
    if (!std::isfinite(number)) return "\\text{" + text + "}";
    if (const std::size_t e = text.find('e'); e != std::string::npos)
        text = text.substr(0, e) + " \\cdot 10^{" + text.substr(e + 1) + "}";
    return text;
}

std::string latex_matrix(const Value& value) {
    if (value.is_number()) return latex_number(value(0, 0), value.error[0]);
    std::string text = "\\begin{bmatrix}";
    for (int r = 0; r < value.rows; ++r) {
        if (r > 0) text += " \\\\ ";
        for (int c = 0; c < value.columns; ++c)
            text += (c > 0 ? " & " : "") + latex_number(value(r, c), value.error[value.index(r, c)]);
    }
    return text + "\\end{bmatrix}";
}

std::string latex_names(const Expression& e) { return latex(e, false); }
std::string latex_numbers(const Expression& e) { return latex(e, true); }

std::string latex_text(std::string_view utf8) {
    std::string text;
    while (!utf8.empty()) {
        const auto first = static_cast<unsigned char>(utf8.front());
        std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
        // Latin letters with accents, U+00C0 … U+00FF, are in every font; other characters need a name.
        std::string found = first >= ' ' && first < 127        ? std::string(1, utf8.front())
                            : first == 0xC3 && utf8.size() > 1 ? std::string(utf8.substr(0, 2))
                            : first < ' '                      ? " "
                                                               : "?";
        for (const auto& [sign, name] : kSpecial)
            if (utf8.starts_with(sign)) {
                found = name;
                length = sign.size();
                break;
            }
        text += found;
        utf8.remove_prefix(std::min(length, utf8.size()));
    }
    return text;
}

std::string latex_color(const glm::vec3& srgb) {
    const auto share = [](float s) { return with_decimals(static_cast<double>(s), 3); };
    return share(srgb.r) + "," + share(srgb.g) + "," + share(srgb.b);
}

}  // namespace normalscope

#include "ui/tabs/derivation_passages.h"

#include <algorithm>
#include <string>

namespace normalscope {

std::vector<AlignedEquation> fitted(const Look& look, std::size_t count, const MakeEquation& make, float width) {
    MathStyle style = math_style(look);
    std::vector<Equation> equations;
    const auto make_all = [&] {
        equations.clear();
        bool fit = true;
        for (std::size_t i = 0; i < count; ++i) {
            equations.push_back(make(style, i));
            fit = fit && width_of(style, equations.back()) <= width;
        }
        return fit;
    };
    if (!make_all()) {
        style = math_style(look, NumberSize::Small);
        if (!make_all())
            for (std::size_t i = 0; i < count; ++i)
                // Rounding to whole pixels may leave it a little too wide at first.
                for (int percent = 100; width_of(style, equations[i]) > width && percent > 30; percent -= 4)
                    equations[i] = make(math_style(look, NumberSize::Small, 0.01f * static_cast<float>(percent)), i);
    }
    return aligned(style, equations, width);
}

std::vector<Passage> passages(const Look& look, const Derivation& derivation, const NamesOrNumbers& shown,
                              std::size_t tangent, float width) {
    const MathStyle style = math_style(look);
    const Meaning by = derivation.n_world_by == Rule::Cofactor ? Meaning::Cofactor : Meaning::InverseTranspose;
    const auto side = [&](const MathStyle& at, std::size_t i, std::size_t operand) {
        return expression_box(
            at, derivation.steps[i].line.operands[operand],
            [&](Place place, const Expression& part) {
                return shown.number(i, place, part.kind == Expression::Kind::Symbol);
            },
            operand_of(1, operand));
    };
    auto equations = fitted(
        look, derivation.steps.size(),
        [&](const MathStyle& at, std::size_t i) { return Equation{side(at, i, 0), side(at, i, 1)}; }, width);

    std::vector<Passage> result;
    for (std::size_t i = 0; i < derivation.steps.size(); ++i) {
        const Step& step = derivation.steps[i];
        Passage passage{.title = {}, .state = step.state, .rows = {}};
        passage.rows.push_back({std::move(equations[i].box), i, 0.0f});
        passage.rows.push_back({paragraph(style, step.reason, width, Ink::Dim, by), 0, look.px(6)});
        if (const std::string sum = shown.numbers ? written_out(step) : std::string(); !sum.empty())
            passage.rows.push_back({paragraph(style, sum, width, Ink::Plain, by), 0, look.px(6)});
        if (!step.remark.empty()) {
            const Ink ink = step.state == Step::State::Fails ? Ink::Bad : Ink::Plain;
            passage.rows.push_back({paragraph(style, step.remark, width, ink, by), 0, look.px(8)});
        }
        result.push_back(std::move(passage));
    }
    const std::size_t lines = derivation.steps.size();
    result.push_back(check_passage(look, derivation, shown, tangent, lines, width));
    result.push_back(homogeneous_passage(look, derivation, shown, lines + 2, width));
    return result;
}

}  // namespace normalscope

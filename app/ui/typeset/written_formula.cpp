#include "ui/typeset/written_formula.h"

#include "core/formula/formula.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace normalscope {

namespace {

constexpr std::size_t kMostPieces = 1500;  // of an expression; more would not fit its lines
constexpr std::size_t kMostLines = 6;
constexpr std::size_t kLongestTip = 1500;

// A text's first bytes, no letter of it cut in two.
std::string beginning(const std::string& text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) --bytes;
    return text.substr(0, bytes) + "…";
}

WrittenFormula lay_out(const Look& look, const std::string& text, float width) {
    WrittenFormula result;
    result.formula = text;
    result.font = look.fonts.letters;
    result.width = width;
    const formulas::Formula formula = formulas::read(text);  // the scene's own can always be read
    result.parameters = formula.parameters;
    std::array<std::vector<formulas::Piece>, 4> pieces;
    for (std::size_t i = 0; i < 4; ++i) {
        pieces[i] = formulas::pieces(formula.graph, formula.expressions()[i], kMostPieces);
        result.texts[i] = beginning(formulas::to_text(pieces[i]), kLongestTip);
    }
    // All of one size: as large as leaves each on one line, or else somewhat smaller over several.
    for (const float shrink : {1.0f, 0.85f, 0.7f}) {
        const MathStyle style = math_style(look, NumberSize::Usual, shrink);
        bool fits = true;
        for (std::size_t i = 0; i < 4; ++i) {
            result.boxes[i] = formula_box(style, pieces[i], width, kMostLines);
            fits &= result.boxes[i].whole && !result.boxes[i].broken_inside &&
                    result.boxes[i].lines <= (shrink == 1.0f ? 1u : 2u);
        }
        if (fits) break;
    }
    return result;
}

}  // namespace

void written_formula(const Look& look, std::optional<WrittenFormula>& written_before, const std::string& formula,
                     float width, std::size_t lines, std::span<const std::string> values) {
    const MathStyle style = math_style(look);
    std::array<MathBox, 4> names;
    float sign = 0.0f, at_right = 0.0f;
    for (std::size_t i = 0; i < lines; ++i) {
        names[i] = derivative_name(style, i);
        sign = std::max(sign, names[i].width);
    }
    if (!values.empty()) at_right = look.px(76);
    const MathBox equals = written(style, style.upright, "=", Ink::Plain);
    const float gap = std::round(0.3f * style.em), right = sign + equals.width + 2 * gap;
    const float room = width - right - at_right;
    auto& now = written_before;
    if (!now || now->formula != formula || now->font != look.fonts.letters || now->width != room)
        now = lay_out(look, formula, room);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < lines; ++i) {
        const MathBox& box = now->boxes[i].box;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float ascent = std::max(box.ascent, names[i].ascent), descent = std::max(box.descent, names[i].descent);
        const float height = ascent + descent + look.px(3);
        ImGui::Dummy({width, height});
        if (!now->boxes[i].whole) tip(look, now->texts[i].c_str());
        const float y = std::round(at.y + ascent + look.px(1));
        draw_math(list, look, names[i], {std::round(at.x + sign - names[i].width), y});
        draw_math(list, look, equals, {std::round(at.x + sign + gap), y});
        list.PushClipRect(at, {at.x + right + room, at.y + height}, true);
        draw_math(list, look, box, {std::round(at.x + right), y});
        list.PopClipRect();
        if (i >= values.size()) continue;
        const float wide = ImGui::CalcTextSize(values[i].c_str()).x;
        list.AddText({std::round(at.x + width - wide), y - std::round(look.fonts.body->Ascent)}, packed(look.text),
                     values[i].c_str());
    }
}

}  // namespace normalscope

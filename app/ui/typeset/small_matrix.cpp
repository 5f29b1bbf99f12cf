#include "ui/typeset/small_matrix.h"

#include "core/scene/palette.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace normalscope {

namespace {

constexpr float kRow = 17.0f, kLabel = 18.0f, kPad = 3.0f;

std::string entry_text(const Value& value, int row, int column, int decimals) {
    const double number = value.clean(row, column);
    return number == 0.0 ? "0" : fixed_unless_small(number, decimals);
}

float widest_entry(const Value& value, const ImFont* font, int decimals) {
    float widest = 0.0f;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            widest = std::max(
                widest, font->CalcTextSizeA(font->FontSize, 1e9f, 0, entry_text(value, r, c, decimals).c_str()).x);
    return widest;
}

// As many decimals as fit into the columns, at most two: the numbers are to be compared at a glance.
int decimals_that_fit(const Value& value, const ImFont* font, float column) {
    int decimals = 2;
    while (decimals > 0 && widest_entry(value, font, decimals) > column) --decimals;
    return decimals;
}

void brackets(const Look& look, ImDrawList& list, ImVec2 low, ImVec2 high, const ImVec4& ink) {
    const float lip = look.px(4), weight = std::max(1.0f, look.px(1.25f));
    for (const float side : {0.0f, 1.0f}) {
        const float x = side == 0.0f ? low.x : high.x, inward = side == 0.0f ? lip : -lip;
        list.PathLineTo({x + inward, low.y});
        list.PathLineTo({x, low.y});
        list.PathLineTo({x, high.y});
        list.PathLineTo({x + inward, high.y});
        list.PathStroke(packed(ink), 0, weight);
    }
}

void entries(const Look& look, ImDrawList& list, const Value& value, ImVec2 low, float width) {
    const ImFont* font = look.fonts.small;
    const float pad = look.px(5), column = (width - 2 * pad) / 3, row = look.px(kRow);
    const int decimals = decimals_that_fit(value, font, column - look.px(4));
    // Numbers with exponents may be wider than that: rather small than one over the other.
    const float size = font->FontSize * std::min(1.0f, (column - look.px(4)) / widest_entry(value, font, decimals));
    const auto width_of = [&](const std::string& text) { return font->CalcTextSizeA(size, 1e9f, 0, text.c_str()).x; };
    // A zero stands where the others have their units, as if it had the decimals too.
    const std::string tail = decimals > 0 ? "." + std::string(static_cast<std::size_t>(decimals), '0') : "";
    const float beyond = width_of(tail);
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            const std::string text = entry_text(value, r, c, decimals);
            const bool zero = text == "0";
            const float right = low.x + pad + column * static_cast<float>(c + 1) - look.px(3) - (zero ? beyond : 0.0f);
            list.AddText(font, size,
                         {std::round(right - width_of(text)),
                          std::round(low.y + look.px(kPad) + row * static_cast<float>(r) + (row - size) / 2)},
                         packed(zero ? look.dim : look.text), text.c_str());
        }
}

}  // namespace

float height_of_matrices(const Look& look) { return look.px(kLabel) + 3 * look.px(kRow) + 2 * look.px(kPad); }

void row_of_matrices(const Look& look, std::span<const SmallMatrix> matrices) {
    const float whole = ImGui::GetContentRegionAvail().x, gap = look.px(13);
    const auto count = static_cast<float>(matrices.size());
    const float width = std::floor((whole - gap * (count - 1)) / count);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float height = height_of_matrices(look), top = from.y + look.px(kLabel);
    const ImFont* font = look.fonts.small;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float x = from.x;
    for (const SmallMatrix& m : matrices) {
        const auto extent = [&](const char* text) { return font->CalcTextSizeA(font->FontSize, 1e9f, 0, text); };
        const float middle = (top + from.y + height) / 2;
        if (*m.sign)
            list.AddText(
                look.fonts.strong, look.fonts.strong->FontSize,
                {std::round(x - gap / 2 -
                            look.fonts.strong->CalcTextSizeA(look.fonts.strong->FontSize, 1e9f, 0, m.sign).x / 2),
                 std::round(middle - look.fonts.strong->FontSize / 2)},
                packed(look.dim), m.sign);
        ImGui::SetCursorScreenPos({x, from.y});
        ImGui::Dummy({width, height});
        tip(look, m.about);
        list.AddText(font, font->FontSize, {std::round(x + (width - extent(m.label).x) / 2), from.y}, packed(m.ink),
                     m.label);
        if (m.value) {
            brackets(look, list, {x, top}, {x + width, from.y + height}, m.ink);
            entries(look, list, *m.value, {x, top}, width);
        } else {
            list.AddText(font, font->FontSize,
                         {std::round(x + (width - extent("—").x) / 2), std::round(middle - font->FontSize / 2)},
                         packed(look.dim), "—");
        }
        x += width + gap;
    }
    ImGui::SetCursorScreenPos({from.x, from.y + height});
    ImGui::Dummy({whole, 0});
}

namespace {

// ImGui breaks lines after any full stop as well, even in the middle of a number.
std::string broken_at_spaces(std::string text, float width) {
    const auto end_of_word = [&](std::size_t from) { return std::min(text.find_first_of(" \n", from), text.size()); };
    std::size_t line = 0;
    for (std::size_t end = end_of_word(0); end < text.size();) {
        const std::size_t next = end_of_word(end + 1);
        if (text[end] == ' ' && ImGui::CalcTextSize(text.data() + line, text.data() + next).x > width) text[end] = '\n';
        if (text[end] == '\n') line = end + 1;
        end = next;
    }
    return text;
}

}  // namespace

void wrapped(const Look& look, const ImVec4& ink, const std::string& words) {
    ImGui::PushFont(look.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    const float width = ImGui::GetContentRegionAvail().x;
    const std::string text = broken_at_spaces(words, width);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void remark(const Look& look, const ImVec4& stripe, const std::string& text) {
    const float inset = look.px(10);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::Indent(inset);
    wrapped(look, look.text, text);
    ImGui::Unindent(inset);
    ImGui::GetWindowDrawList()->AddRectFilled({from.x, from.y + look.px(1)},
                                              {from.x + look.px(3), ImGui::GetItemRectMax().y - look.px(1)},
                                              packed(stripe), look.px(1));
}

void reflection_remark(const Look& look) {
    remark(
        look, to_imgui(rule_color(Rule::Cofactor)),
        "det M < 0: (M⁻¹)ᵀ n keeps pointing outward, as gradients do; cof(M) n follows the winding, which M reverses. "
        "Each is right for its own question.");
}

}  // namespace normalscope

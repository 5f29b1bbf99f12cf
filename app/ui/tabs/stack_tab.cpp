#include "ui/tabs/stack_tab.h"

#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/panel/stack_section.h"
#include "ui/typeset/small_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

constexpr std::size_t kFewEntries = 4;    ///< up to which all are open at first
constexpr float kMostOfTheHeight = 0.5f;  ///< that the entries may take before they scroll by themselves

// How much of entry i acts, 0 … 1.
float acting(const Scene& scene, std::size_t i) {
    const double position = scene.stack_position.value_or(static_cast<double>(scene.stack.size()));
    return static_cast<float>(std::clamp(position - static_cast<double>(i), 0.0, 1.0));
}

void entry_header(const Look& look, const Scene& scene, std::size_t i, bool& open) {
    const float width = ImGui::GetContentRegionAvail().x, height = look.px(26);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    if (ImGui::Button("##entry", {width, height})) open = !open;
    ImGui::PopStyleColor();
    const float part = acting(scene, i), middle = low.y + height / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({low.x, low.y + look.px(5)}, {low.x + look.px(3), low.y + height - look.px(5)},
                       packed(look.line));
    list.AddRectFilled({low.x, low.y + look.px(5)},
                       {low.x + look.px(3), low.y + look.px(5) + part * (height - look.px(10))}, packed(look.accent));
    if (!look.still)
        draw_icon(list, open ? Icon::Down : Icon::Right, {low.x + look.px(14), middle}, look.px(11), packed(look.dim));
    float x = low.x + look.px(look.still ? 12 : 26);
    const auto word = [&](const ImFont* font, const ImVec4& ink, const std::string& text, float gap) {
        list.AddText(font, font->FontSize, {x, std::round(middle - font->FontSize / 2)}, packed(ink), text.c_str());
        x += font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.c_str()).x + gap;
    };
    const StackEntry& entry = scene.stack[i];
    word(look.fonts.body, look.dim, std::to_string(i + 1), look.px(7));
    word(look.fonts.strong, part > 0.0f ? look.text : look.dim, std::string(name(entry)), look.px(10));
    word(look.fonts.body, look.dim, shortened(summary(entry), low.x + width - x), 0);
}

void entry_matrices(const Look& look, const EntryAlgebra& algebra) {
    const std::array<SmallMatrix, 3> matrices{
        {{"A", algebra.a, look.text, "What the entry does to vectors: the upper left 3×3 of its matrix."},
         {"A⁻¹", algebra.inverse, look.text, "The way back. For a single entry it is easy to find."},
         {"(A⁻¹)ᵀ", algebra.inverse_transpose, look.readable(Rule::InverseTranspose),
          "What the entry does to normals."}}};
    row_of_matrices(look, matrices);
    for (const std::string& line : algebra.observations) wrapped(look, look.dim, line + ".");
}

void entry_card(const Look& look, const Scene& scene, StackTab& tab, std::size_t i) {
    StackTab::Row& row = tab.rows[i];
    const float width = ImGui::GetContentRegionAvail().x;
    // A hundred of them: what cannot be seen only takes its room.
    const float expected = row.height > 0.0f ? row.height : look.px(26);
    if ((row.height > 0.0f || !row.open) && !ImGui::IsRectVisible({width, expected})) {
        ImGui::Dummy({width, expected});
        return;
    }
    ImGui::PushID(static_cast<int>(i));
    const float top = ImGui::GetCursorScreenPos().y;
    bool open = row.open;
    ImGui::BeginGroup();
    entry_header(look, scene, i, open);
    if (row.open) {
        entry_matrices(look, tab.algebra[i]);
        ImGui::Dummy({0, look.px(4)});
    }
    ImGui::EndGroup();
    row.height = ImGui::GetItemRectMax().y - top;
    if (open != row.open) row = {open, 0.0f};
    ImGui::PopID();
}

}  // namespace

void stack_entries(const Look& look, const Scene& scene, StackTab& tab) {
    if (!section(look, "Entries")) return;
    tip(look, "A, its inverse and its inverse transpose, for each entry by itself.");
    if (tab.rows.size() != scene.stack.size())
        tab.rows.resize(scene.stack.size(), {.open = scene.stack.size() <= kFewEntries});
    const float spacing = look.px(2);
    float height = 0.0f;
    for (const StackTab::Row& row : tab.rows) height += (row.height > 0.0f ? row.height : look.px(26)) + spacing;
    const float most = std::max(kMostOfTheHeight * ImGui::GetIO().DisplaySize.y, look.px(160));
    const bool scrolls = height > most;
    if (scrolls)
        ImGui::BeginChild("##entries", {0, most}, ImGuiChildFlags_None,
                          ImGuiWindowFlags_NavFlattened | ImGuiWindowFlags_AlwaysVerticalScrollbar);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(6), spacing));
    for (std::size_t i = 0; i < scene.stack.size(); ++i) entry_card(look, scene, tab, i);
    ImGui::PopStyleVar();
    if (scrolls) ImGui::EndChild();
    if (scene.stack.empty()) wrapped(look, look.dim, "There is none: M = I, and every rule gives n.");
}

void stack_products(const Look& look, const Scene& scene, StackTab& tab) {
    if (!section(look, "Composite of inverses") || scene.stack.empty()) return;
    const std::size_t count = scene.stack.size();
    const double position =
        std::min(scene.stack_position.value_or(static_cast<double>(count)), static_cast<double>(count));
    const auto whole = static_cast<std::size_t>(position);
    if (whole == 0) return wrapped(look, look.dim, "No entry acts in full yet; the products of whole entries follow.");
    const EntryAlgebra& last = tab.algebra[whole - 1];
    const ImVec4 right = look.readable(Rule::InverseTranspose);
    wrapped(look, look.dim,
            whole == 1 ? std::string("The first entry by itself:")
                       : "Entries 1 to " + std::to_string(whole) +
                             ", the last standing leftmost; nothing is inverted but single entries:");
    const std::array<SmallMatrix, 3> matrices{
        {{"M", last.product, look.text, "The product of the entries, the first of which acts first: M = last … first."},
         {"product of (A⁻¹)ᵀ", last.composite, right,
          "The composite of inverses: the single (A⁻¹)ᵀ, multiplied in the original order, since inverting reverses "
          "the order and transposing reverses it back."},
         {"(M⁻¹)ᵀ", last.inverted_product, right, "The inverse of the composite: first the product, then inverted."}}};
    row_of_matrices(look, matrices);
    if (!last.apart) {
        const auto none =
            std::ranges::find_if(tab.algebra.begin(), tab.algebra.begin() + static_cast<std::ptrdiff_t>(whole),
                                 [](const EntryAlgebra& a) { return !a.inverse; });
        const auto which = none - tab.algebra.begin() + 1;
        return remark(look, look.bad,
                      static_cast<std::size_t>(which) <= whole
                          ? "Entry " + std::to_string(which) +
                                " has no inverse, so neither has M. The cofactor still multiplies in the same "
                                "order."
                          : "The product has no inverse that numbers of 16 digits could hold.");
    }
    const Difference& apart = *last.apart;
    if (apart.largest == 0.0) return remark(look, look.good, "✓ The two are equal, to the last digit.");
    remark(look, apart.within_rounding ? look.good : look.bad,
           std::string(apart.within_rounding ? "✓ The two are equal but for rounding: " : "The two differ by ") +
               fixed_unless_small(apart.largest) + " at most, " + fixed_unless_small(apart.relative) +
               " of the largest entry.");
}

void draw_stack_tab(Scene& scene, StackTab& tab, const SideContext& context) {
    const Look& look = context.look;
    if (tab.algebra_of != scene.stack) {
        tab.algebra_of = scene.stack;
        tab.algebra = stack_algebra(scene.stack);
        for (StackTab::Row& row : tab.rows) row.height = 0.0f;  // what is said of an entry may take another line
    }
    player_controls(look, scene, tab.player);
    stack_entries(look, scene, tab);
    stack_products(look, scene, tab);
    wrong_orders(look, scene, tab, context.frame);
    rotation_and_stretch(look, scene, tab);
}

}  // namespace normalscope

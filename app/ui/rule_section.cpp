#include "ui/panel.h"

#include "core/palette.h"
#include "ui/widgets.h"

#include <array>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

struct RuleButton {
    Rule rule;
    const char *label, *key, *about;
};
constexpr std::array<RuleButton, 3> kButtons{{
    {Rule::Naive, "naive", "N",
     "M n: the normal treated as if it were a vector. Right for rigid maps, and up to length for uniform scales and "
     "reflections; "
     "wrong as soon as M stretches unevenly. (N)"},
    {Rule::InverseTranspose, "inverse transpose", "I",
     "(M⁻¹)ᵀ n: how a gradient transforms, ∇(f ∘ M⁻¹) = (M⁻¹)ᵀ ∇f. Perpendicular to the surface whatever M does, and "
     "always "
     "pointing outward. (I)"},
    {Rule::Cofactor, "cofactor", "C",
     "cof(M) n, where cof(M) = det(M) (M⁻¹)ᵀ: exists even where M has no inverse. Follows the triangle's winding, "
     "which a "
     "reflection turns over. (C)"},
}};

void button(const Look& look, Scene& scene, const RuleButton& b, bool exists, ImVec2 size) {
    const bool chosen = scene.rule == b.rule;
    const glm::vec3 color = rule_color(b.rule);
    const ImVec4 tint = to_imgui(color), ink = look.readable(b.rule);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, exists ? 1.0f : 0.5f);
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? faded(tint, 0.20f) : look.card);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(tint, chosen ? 0.26f : 0.12f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(tint, 0.32f));
    ImGui::PushID(b.label);
    if (ImGui::Button("##rule", size)) scene.rule = b.rule;
    ImGui::PopID();
    ImGui::PopStyleColor(3);

    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen) list.AddRect({low.x + 1, low.y + 1}, {high.x - 1, high.y - 1}, packed(tint), look.px(6), 0, look.px(2));
    const auto centred = [&](ImFont* font, float y, ImVec4 ink_color, std::string_view text) {
        const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.data(), text.data() + text.size());
        list.AddText(font, font->FontSize, {std::round((low.x + high.x - extent.x) / 2), y}, packed(ink_color),
                     text.data(), text.data() + text.size());
    };
    draw_arrow(list, arrow_kind(b.rule), {low.x + look.px(10), low.y + look.px(13)},
               {low.x + look.px(38), low.y + look.px(13)}, look.px(3), packed(tint));
    const ImVec2 key = look.fonts.small->CalcTextSizeA(look.fonts.small->FontSize, 1e9f, 0, b.key);
    list.AddText(look.fonts.small, look.fonts.small->FontSize, {high.x - key.x - look.px(8), low.y + look.px(4)},
                 packed(look.dim), b.key);
    centred(look.fonts.title, low.y + look.px(18), ink, formula(b.rule));
    centred(look.fonts.small, low.y + look.px(44), chosen ? look.text : look.dim, b.label);
    ImGui::PopStyleVar();

    const std::string about =
        std::string(b.about) +
        (exists
             ? ""
             : "\n\nNot here: this M has no inverse. It can still be chosen; the surface is then drawn without light.");
    tip(look, about.c_str());
}

}  // namespace

void rule_buttons(Scene& scene, const PanelContext& context) {
    const Look& look = context.look;
    const bool invertible =
        !context.frame.probe || context.frame.probe->normals[static_cast<std::size_t>(Rule::InverseTranspose)];
    const float gap = look.px(6), width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
    for (std::size_t i = 0; i < kButtons.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        button(look, scene, kButtons[i], kButtons[i].rule != Rule::InverseTranspose || invertible,
               {width, look.px(66)});
    }
}

void view_buttons(Scene& scene, const PanelContext& context) {
    static constexpr std::array<Choice, 3> kViews{
        {{"single", "The object by the chosen rule alone. (V for the next view)"},
         {"split", "Naive at the left, correct at the right, one camera. (V for the next view)"},
         {"overlay", "The rules' arrows on one object, and the angle between them. (V for the next view)"}}};
    int view = static_cast<int>(scene.view);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (segmented(context.look, "view", view, kViews)) scene.view = static_cast<ViewMode>(view);
}

}  // namespace normalscope

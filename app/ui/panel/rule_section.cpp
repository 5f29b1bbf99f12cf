#include "ui/panel/panel.h"

#include "core/frame/drawn_arrows.h"
#include "core/scene/mistakes.h"
#include "core/scene/palette.h"
#include "core/scene/scene_fields.h"
#include "ui/kit/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

struct RuleButton {
    Rule rule;
    const char *label, *key, *about;
};
// The last is behind a press.
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
     "which a reflection reverses. (C)"},
}};

constexpr float kBesideLabel = 14.0f;  // at its left and its right in sum

float label_room(const Look& look, const RuleButton& b) {
    const ImFont& font = *look.fonts.small;
    return std::ceil(font.CalcTextSizeA(font.FontSize, 1e9f, 0, b.label).x + look.px(kBesideLabel));
}

// The largest font in which the text fits.
const ImFont* fitting(const Look& look, std::string_view text, float width) {
    for (const ImFont* font : {look.fonts.title, look.fonts.strong})
        if (font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.data(), text.data() + text.size()).x <= width)
            return font;
    return look.fonts.small;
}

// Some formulas go on in words, which the button has no room for.
std::string_view before_comma(std::string_view text) { return text.substr(0, text.find(", as")); }

void button(const Look& look, const Scene& scene, const RuleButton& b, bool exists, ImVec2 size, Requests& requests) {
    // The scene may put another mistake into the naive rule's place.
    const bool mistaken = b.rule == Rule::Naive && scene.mistake != Mistake::Naive;
    const MistakeText mistake = text(scene.mistake);
    const std::string_view label = mistaken ? mistake.title : std::string_view(b.label),
                           mathematics = mistaken ? before_comma(mistake.formula) : formula(b.rule);
    const bool off = !can_choose(scene, b.rule);
    // In the split view: what the right half shows.
    const bool chosen = (can_choose(scene, scene.rule) ? scene.rule : pane_rules(scene).back()) == b.rule;
    const glm::vec3 color = rule_color(b.rule);
    const ImVec4 tint = to_imgui(color), ink = look.readable(b.rule);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, exists && !off ? 1.0f : 0.5f);
    ImGui::BeginDisabled(off);
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? faded(tint, 0.20f) : look.card);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(tint, chosen ? 0.26f : 0.12f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(tint, 0.32f));
    ImGui::PushID(b.label);
    if (ImGui::Button("##rule", size)) requests.rule = b.rule;
    ImGui::PopID();
    ImGui::EndDisabled();
    ImGui::PopStyleColor(3);

    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen) list.AddRect({low.x + 1, low.y + 1}, {high.x - 1, high.y - 1}, packed(tint), look.px(6), 0, look.px(2));
    const auto centred = [&](const ImFont* font, float middle, ImVec4 ink_color, std::string_view words) {
        const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.data(), words.data() + words.size());
        list.AddText(font, font->FontSize,
                     {std::round((low.x + high.x - extent.x) / 2), std::round(middle - font->FontSize / 2)},
                     packed(ink_color), words.data(), words.data() + words.size());
    };
    draw_arrow(list, arrow_look(arrow_kind(b.rule)), {low.x + look.px(10), low.y + look.px(13)},
               {low.x + look.px(38), low.y + look.px(13)}, look.px(3), packed(tint));
    const ImVec2 key = look.fonts.small->CalcTextSizeA(look.fonts.small->FontSize, 1e9f, 0, b.key);
    list.AddText(look.fonts.small, look.fonts.small->FontSize, {high.x - key.x - look.px(8), low.y + look.px(4)},
                 packed(look.dim), b.key);
    centred(fitting(look, mathematics, size.x - look.px(12)), low.y + look.px(18) + look.fonts.title->FontSize / 2, ink,
            mathematics);
    ImGui::PushFont(look.fonts.small);
    const std::string whole_label = shortened(std::string(label), size.x - look.px(kBesideLabel));
    ImGui::PopFont();
    centred(look.fonts.small, low.y + look.px(44) + look.fonts.small->FontSize / 2, chosen ? look.text : look.dim,
            whole_label);
    ImGui::PopStyleVar();

    const std::string about =
        (mistaken ? std::string(mistake.title) + ", in the naive rule's place: " + std::string(mistake.formula) + ". " +
                        std::string(mistake.reason) + " (N)"
                  : std::string(b.about)) +
        (exists
             ? ""
             : "\n\nNot here: this M has no inverse. It can still be chosen; the surface is then drawn without light.");
    tip(look, off ? "The split view already shows it on the left; the other two choose what it is compared with."
                  : about.c_str());
}

bool has_inverse(const Frame& frame) {
    return !frame.probe || !frame.probe->object.has_normal() || frame.probe->normals[Rule::InverseTranspose];
}

}  // namespace

bool cofactor_in_sight(const Scene& scene, const PanelContext& context) {
    const bool spoken_of = scene.rule == Rule::Cofactor ||
                           (scene.arrows.show && std::ranges::count(*scene.arrows.show, ArrowKind::Cofactor) > 0);
    return context.unfolded.rules || spoken_of || !has_inverse(context.frame);
}

void rule_buttons(const Scene& scene, const PanelContext& context) {
    const Look& look = context.look;
    const bool invertible = has_inverse(context.frame);
    const std::size_t count = cofactor_in_sight(scene, context) ? kButtons.size() : kButtons.size() - 1;
    constexpr float kMore = 18.0f, kHeight = 66.0f;
    const float gap = look.px(4), more = look.px(kMore) + look.px(2);
    const float all = ImGui::GetContentRegionAvail().x - more - static_cast<float>(count - 1) * gap;
    // As wide as each other, but that the inverse transpose has what its long name needs.
    const float longest = std::max(label_room(look, kButtons[1]), std::floor(all / static_cast<float>(count))),
                others = std::floor((all - longest) / static_cast<float>(count - 1));
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        button(look, scene, kButtons[i], kButtons[i].rule != Rule::InverseTranspose || invertible,
               {i == 1 ? longest : others, look.px(kHeight)}, context.requests);
    }
    ImGui::SameLine(0, look.px(2));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (look.px(kHeight) - look.px(kMore)) / 2);
    bool& unfolded = context.unfolded.rules;
    if (icon_button(look, "##rules",
                    {.icon = unfolded ? Icon::Left : Icon::More,
                     .about = unfolded ? "Fewer: the two rules that matter most."
                                       : "More: the cofactor matrix, and the mistakes that programs make.",
                     .side = kMore}))
        unfolded = !unfolded;
}

void view_buttons(Scene& scene, const PanelContext& context) {
    static constexpr std::array<Segment, 4> kViews{
        {{"single", "The object by the chosen rule alone. (V for the next view)"},
         {"split", "Naive at the left, correct at the right, one camera. (V for the next view)"},
         {"overlay", "The rules' arrows on one object, and the angle between them. (V for the next view)"},
         {"flat", "The plane z = 0 seen straight on: the curve before and after M. (V for the next view)"}}};
    int view = static_cast<int>(scene.view);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (segmented(context.look, "view", view, kViews)) scene.view = static_cast<ViewMode>(view);
}

}  // namespace normalscope

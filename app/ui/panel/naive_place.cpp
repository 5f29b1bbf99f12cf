#include "core/base/error.h"
#include "core/frame/drawn_arrows.h"
#include "core/scene/mistakes.h"
#include "core/scene/palette.h"
#include "core/scene/scene_fields.h"
#include "ui/kit/widgets.h"
#include "ui/panel/panel.h"

#include <imgui_internal.h>  // TempInputIsActive: whether a number is being typed

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace normalscope {

namespace {

void mistakes(const Look& look, Scene& scene) {
    const ImFont* small = look.fonts.small;
    for (const auto& [mistake, id] : kMistakeNames) {
        const MistakeText words = text(mistake);
        const std::string title(words.title), formula(words.formula);
        ImGui::PushID(static_cast<int>(mistake));
        if (ImGui::Selectable("##choose", mistake == scene.mistake)) scene.mistake = mistake;
        ImGui::PopID();
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        tip(look, std::string(words.reason).c_str());
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float top = std::round((low.y + high.y - ImGui::GetFontSize()) / 2);
        list.AddText({low.x + look.px(8), top}, packed(look.text), title.c_str());
        list.AddText(
            small, small->FontSize,
            {high.x - look.px(8) - small->CalcTextSizeA(small->FontSize, 1e9f, 0, formula.c_str()).x, top + look.px(1)},
            packed(look.readable(Rule::Naive)), formula.c_str());
    }
}

// The power that a slider from 1 at its left to `last` at its right stands for.
double caught(double power) {
    power = std::round(100.0 * power) / 100.0;
    for (const double stop : {1.0, 0.0, -1.0})
        if (!ImGui::GetIO().KeyAlt && std::abs(power - stop) < 0.04) power = stop;
    return power + 0.0;  // + 0: not −0
}

bool has_inverse(const Scene& scene) {
    try {
        return world_from_object(scene).normal_matrices_by_rule().rank == 3;
    } catch (const InputError&) {  // said elsewhere
        return true;
    }
}

// Over the frame that Dear ImGui drew: the way from the one rule to the other, and where on it the arrows are.
void draw_way(const Look& look, double power, bool inverse) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImGuiStyle& style = ImGui::GetStyle();
    const float inset = 2.0f + style.GrabMinSize / 2;  // as Dear ImGui's slider has it
    const auto x = [&](double p) {
        return std::round(low.x + inset + static_cast<float>((1.0 - p) / 2.0) * (high.x - low.x - 2 * inset));
    };
    const ImFont* font = look.fonts.small;
    const auto write = [&](float at, float before, const ImVec4& ink, std::string_view words) {
        const float width = font->CalcTextSizeA(font->FontSize, 1e9f, 0, words.data(), words.data() + words.size()).x;
        list.AddText(font, font->FontSize, {std::round(at - before * width), low.y + look.px(3)}, packed(ink),
                     words.data(), words.data() + words.size());
    };
    const ImVec4 wrong = to_imgui(rule_color(Rule::Naive)), right = to_imgui(rule_color(Rule::InverseTranspose));
    const float line = high.y - look.px(5), end = inverse ? x(-1.0) : x(0.0), weight = look.px(2);
    list.AddRectFilledMultiColor({x(1.0), line - weight / 2}, {end, line + weight / 2}, packed(wrong),
                                 packed(inverse ? right : look.dim), packed(inverse ? right : look.dim), packed(wrong));
    for (const double stop : {1.0, 0.0, -1.0})
        if (inverse || stop >= 0.0) list.AddCircleFilled({x(stop), line}, look.px(2.5f), packed(look.dim));
    write(low.x + look.px(8), 0.0f, look.readable(Rule::Naive), formula(Rule::Naive));
    write(x(0.0), 0.5f, look.dim, "rotation only");
    write(high.x - look.px(8), 1.0f, inverse ? look.readable(Rule::InverseTranspose) : look.dim,
          inverse ? formula(Rule::InverseTranspose) : "no inverse");
    const float at = x(std::max(power, inverse ? -1.0 : 0.0));
    list.AddCircleFilled({at, line}, look.px(5.5f), packed(look.card));
    list.AddCircleFilled({at, line}, look.px(4.5f), packed(wrong));
}

void power_slider(const Look& look, Scene& scene, float width) {
    const bool inverse = has_inverse(scene);
    const double first = 1.0, last = -1.0;
    double power = scene.power;
    const ImVec4 nothing(0, 0, 0, 0);
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##power"));
    ImGui::SetNextItemWidth(width);
    for (const ImGuiCol part : {ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) ImGui::PushStyleColor(part, nothing);
    ImGui::PushStyleColor(ImGuiCol_Text, typing ? look.text : nothing);
    const bool moved = ImGui::SliderScalar("##power", ImGuiDataType_Double, &power, &first, &last, "%.3g");
    ImGui::PopStyleColor(3);
    if (!typing) draw_way(look, scene.power, inverse);
    tip(look, inverse ? "Bends the orange arrows from M n to (M⁻¹)ᵀ n. M₃ = R S is a stretch, then a rotation; they "
                        "are sent through R Sᵖ: with p = 1 that is M₃, with 0 the rotation alone, with −1 the inverse "
                        "transpose. They are right at that end, and nowhere before it."
                      : "Bends the orange arrows from M n to the rotation alone, by R Sᵖ where M₃ = R S is a stretch, "
                        "then a rotation. It ends there: M has no inverse, and p < 0 would divide by a stretch of 0.");
    if (!moved) return;
    scene.power = std::clamp(caught(power), inverse ? -1.0 : 0.0, 1.0);
    if (can_choose(scene, Rule::Naive)) scene.rule = Rule::Naive;  // so that the light follows
}

}  // namespace

void naive_place(Scene& scene, const PanelContext& context) {
    const Look& look = context.look;
    const MistakeText chosen = text(scene.mistake);
    const float width = ImGui::GetContentRegionAvail().x;
    if (scene.mistake == Mistake::Naive) {
        if (!context.unfolded.rules) return power_slider(look, scene, width);
        const char* const label = "mistakes";
        const float gap = look.px(6), button = ImGui::CalcTextSize(label).x + look.px(18);
        power_slider(look, scene, width - gap - button);
        ImGui::SameLine(0, gap);
        if (ImGui::Button(label, {button, 0})) ImGui::OpenPopup("##mistakes");
        tip(look, "Other mistakes that programs make, to be shown in the naive rule's place by the orange arrows.");
        ImGui::SetNextWindowSize({width, 0});
        if (!ImGui::BeginPopup("##mistakes")) return;
        mistakes(look, scene);
        ImGui::EndPopup();
        return;
    }
    if (begin_combo(look, "##mistake", "mistake: " + std::string(chosen.title), width)) {
        mistakes(look, scene);
        ImGui::EndCombo();
    } else {
        tip(look, "What the orange arrows show in the naive rule's place. The first in the list is the rule itself.");
    }
    ImGui::PushFont(look.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, look.dim);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::TextUnformatted(chosen.reason.data(), chosen.reason.data() + chosen.reason.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace normalscope

#include "core/base/error.h"
#include "core/scene/palette.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/tabs/stack_tab.h"
#include "ui/typeset/small_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace normalscope {

namespace {

// The mistake that shows what a line is about; the others are there to be compared with.
std::optional<Mistake> mistake_of(const std::string& id) {
    if (id == "inverses-not-reversed") return Mistake::InversesNotReversed;
    if (id == "not-transposed") return Mistake::NotTransposed;
    if (id == "not-inverted") return Mistake::NotInverted;
    if (id == "naive") return Mistake::Naive;
    return std::nullopt;
}

void choose(Scene& scene, Mistake mistake) {
    scene.mistake = mistake;
    // One rule alone would not show it beside the true normal.
    if (scene.view == ViewMode::Single && scene.rule != Rule::Naive) scene.view = ViewMode::Overlay;
}

void order_line(const Look& look, Scene& scene, const OrderOfInverses& order, std::size_t index) {
    const std::optional<Mistake> mistake = mistake_of(order.id);
    const bool chosen = mistake && scene.mistake == *mistake;
    const float width = ImGui::GetContentRegionAvail().x, pad = look.px(8);
    ImGui::PushFont(look.fonts.small);
    const float reason = ImGui::CalcTextSize(order.reason.c_str(), nullptr, false, width - 2 * pad).y;
    ImGui::PopFont();
    const float height = look.px(26) + reason;
    const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + width, low.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec4 tint = to_imgui(rule_color(Rule::Naive));
    ImGui::PushID(static_cast<int>(index));
    if (mistake) {
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? faded(tint, 0.18f) : look.card);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(tint, chosen ? 0.24f : 0.12f));
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(tint, 0.30f));
        if (ImGui::Button("##order", {width, height})) choose(scene, *mistake);
        ImGui::PopStyleColor(3);
        const std::string_view why = text(*mistake).reason;
        tip(look, (std::string(why) + "\nPress to see it in the picture, as the vermillion arrows.").c_str());
        if (chosen)
            list.AddRect({low.x + 1, low.y + 1}, {high.x - 1, high.y - 1}, packed(tint), look.px(6), 0, look.px(2));
    } else {
        ImGui::Dummy({width, height});
    }
    ImGui::PopID();

    const std::string mark = order.is_right ? "✓" : order.degrees_off ? "✗" : "";
    const std::string off = order.degrees_off ? in_degrees(order.degrees_off, 1) : std::string("—");
    const ImVec4 verdict = order.is_right ? look.good : look.bad;
    const ImFont* font = look.fonts.body;
    const float off_width = font->CalcTextSizeA(font->FontSize, 1e9f, 0, off.c_str()).x;
    list.AddText(look.fonts.strong, look.fonts.strong->FontSize, {low.x + pad, low.y + look.px(3)},
                 packed(order.is_right ? look.readable(Rule::InverseTranspose)
                        : mistake      ? look.readable(Rule::Naive)
                                       : look.text),
                 order.formula.c_str());
    list.AddText(font, font->FontSize, {std::round(high.x - pad - off_width), low.y + look.px(3)}, packed(look.text),
                 off.c_str());
    list.AddText(look.fonts.body, look.fonts.body->FontSize, {high.x - pad - look.px(74), low.y + look.px(3)},
                 packed(verdict), mark.c_str());
    list.AddText(look.fonts.small, look.fonts.small->FontSize, {low.x + pad, low.y + look.px(22)}, packed(look.dim),
                 order.reason.c_str(), nullptr, width - 2 * pad);
}

SmallMatrix matrix_of(const char* label, const glm::dmat3& m, const ImVec4& ink, const char* about,
                      const char* sign = "") {
    return {label, value_of(m, 3), ink, about, sign};
}

bool same_probe(const std::optional<Probe>& a, const std::optional<Probe>& b) {
    return a.has_value() == b.has_value() && (!a || (a->point == b->point && a->normal == b->normal));
}

void too_few_for_an_order(const Look& look, Scene& scene) {
    wrapped(look, look.dim, "It takes two active entries to tell the orders apart.");
    if (look.still || scene.stack.size() > 1 || !ImGui::Button("Add a rotation")) return;
    scene.stack.push_back(Rotate{{0, 0, 1}, 30.0});
    scene.stack_position.reset();
}

}  // namespace

void wrong_orders(const Look& look, Scene& scene, StackTab& tab, const Frame& frame) {
    if (!section(look, "Right and wrong orders")) return;
    const std::vector<StackEntry> stack = applied_stack(scene);
    const std::optional<Probe> probe = frame.probe ? with_normal(frame.probe->object) : std::nullopt;
    if (tab.orders_of != stack || !same_probe(tab.orders_at, probe)) {
        tab.orders_of = stack;
        tab.orders_at = probe;
        tab.orders = orders_of_inverses(stack, Transform<World, Object>(product(stack)), probe);
        tab.orders_commute = commute(stack);
    }
    if (stack.size() < 2) return too_few_for_an_order(look, scene);
    wrapped(look, look.dim, "For two entries, M = AB. At the right, how far off each is at the probe.");
    if (tab.orders_commute)
        remark(look, look.text,
               stack.size() == 2 ? "The two entries commute, AB = BA: here no order is wrong."
                                 : "The entries commute: here no order is wrong.");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(6), look.px(3)));
    for (std::size_t i = 0; i < tab.orders.size(); ++i) order_line(look, scene, tab.orders[i], i);
    ImGui::PopStyleVar();
}

void rotation_and_stretch(const Look& look, Scene& scene, StackTab& tab) {
    if (!section(look, "Rotation and stretch")) return;
    NormalMatrices matrices;
    try {
        matrices = world_from_object(scene).normal_matrices_by_rule();
    } catch (const InputError& error) {
        return remark(look, look.bad, error.what());
    }
    if (tab.decomposition_of != matrices.naive || tab.decomposition_rank != matrices.rank) {
        tab.decomposition_of = matrices.naive;
        tab.decomposition_rank = matrices.rank;
        tab.decomposition = decomposition(matrices.naive, matrices.rank);
    }
    const Decomposition& d = tab.decomposition;
    const std::array<SmallMatrix, 3> row{
        {matrix_of("M₃", matrices.naive, look.text, "What M does to vectors."),
         matrix_of(d.reflects ? "R, reflecting" : "R", d.rotation, look.text,
                   "A rotation, with a reflection where det M < 0. It is its own inverse transpose.", "="),
         matrix_of("S", d.stretch, look.readable(Rule::Naive),
                   "A stretch along three perpendicular axes, not necessarily x, y and z.", "·")}};
    row_of_matrices(look, row);
    std::string factors = "S stretches by " + brief(d.axes[0].factor) + ", " + brief(d.axes[1].factor) + " and " +
                          brief(d.axes[2].factor) + "; R turns by " + brief(d.degrees) + "°";
    if (d.reflects) factors += " and mirrors";
    wrapped(look, look.text, factors + (d.unique ? "." : " (M has no inverse: other R would do as well)."));
    wrapped(look, look.dim,
            "Only the stretch hurts normals: (R⁻¹)ᵀ = R turns them as it turns the surface, while S multiplies by its "
            "factors where (S⁻¹)ᵀ = S⁻¹ must divide by them.");
    if (look.still) return;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(look.px(4), look.px(1)));
    ImGui::Checkbox("show the stretch axes in the picture", &scene.show.stretch_axes);
    ImGui::PopStyleVar();
    tip(look,
        "The perpendicular directions that M only stretches, and halfway between the longest and the shortest "
        "the normals that the naive rule treats worst.");
}

}  // namespace normalscope

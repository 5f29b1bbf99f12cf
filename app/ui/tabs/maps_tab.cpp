#include "ui/tabs/maps_tab.h"

#include "core/base/error.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"
#include "ui/typeset/small_matrix.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace normalscope {

namespace {

constexpr std::array<const char*, 4> kHeadings{"direction", "length", "(M⁻¹)ᵀ", "cof(M) n"};
constexpr std::array<const char*, 4> kAbout{
    "Does M n have the true normal's direction for every n? If not: how far off it can be.",
    "Does M n keep the length of every n?", "Does the inverse transpose exist?",
    "What the cofactor gives, against the inverse transpose."};
// Where the columns begin, in logical pixels from the left; the first is the class.
constexpr std::array<float, 4> kColumns{142.0f, 218.0f, 292.0f, 354.0f};

struct Cell {
    std::optional<bool> good;  ///< empty: neither
    std::string word;
};

std::array<Cell, 4> cells(const MapClaims& c) {
    Cell direction{c.naive_direction_right, "right"};
    if (!c.naive_direction_right)
        direction.word = c.rank < 2 ? "none" : "depends";
    else if (!*c.naive_direction_right)
        direction.word = c.worst_degrees ? in_degrees(c.worst_degrees, 1) : "wrong";
    Cell length{c.naive_length_right, "kept"};
    if (!c.naive_length_right)
        length.word = "depends";
    else if (!*c.naive_length_right)
        length.word = "not";
    const Cell exists{c.inverse_transpose_exists, c.inverse_transpose_exists ? "exists" : "none"};
    constexpr std::array<const char*, 4> kGives{"same", "opposite", "only one", "zero"};
    const Cell gives{c.cofactor == CofactorGives::Zero                ? std::optional(false)
                     : c.cofactor == CofactorGives::OppositeDirection ? std::nullopt
                                                                      : std::optional(true),
                     kGives.at(static_cast<std::size_t>(c.cofactor))};
    return {direction, length, exists, gives};
}

void table_row(const Look& look, const MapClassRow& row) {
    const float width = ImGui::GetContentRegionAvail().x, height = look.px(44);
    const ImVec2 low = ImGui::GetCursorScreenPos(), high{low.x + width, low.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::Dummy({width, height});
    tip(look, row.contains_m ? "M is one of these: the claims are computed from M."
                             : "M is none of these: the claims are computed from an example.");
    if (row.contains_m) {
        list.AddRectFilled(low, high, packed(faded(look.accent, 0.10f)), look.px(6));
        list.AddRectFilled(low, {low.x + look.px(4), high.y}, packed(look.accent), look.px(2));
    } else {
        list.AddLine({low.x, high.y}, high, packed(faded(look.line, 0.7f)));
    }
    const float top = low.y + look.px(4);
    const std::string title(name(row.map_class)), what(meaning(row.map_class));
    const ImFont *first = row.contains_m ? look.fonts.strong : look.fonts.body, *small = look.fonts.small;
    const ImVec4 ink = row.contains_m ? look.text : look.dim;
    list.AddText(first, first->FontSize, {low.x + look.px(10), top}, packed(look.text), title.c_str());
    ImGui::PushFont(look.fonts.small);
    list.AddText({low.x + look.px(10), top + look.px(19)}, packed(look.dim), what.c_str());
    ImGui::PopFont();
    const std::array<Cell, 4> claims = cells(row.claims);
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const Cell& cell = claims[i];
        const float x = low.x + look.px(kColumns[i]);
        const ImVec4 mark = !cell.good ? look.dim : *cell.good ? look.good : look.bad;
        list.AddText(look.fonts.body, look.fonts.body->FontSize, {x, top},
                     packed(row.contains_m ? mark : faded(mark, 0.7f)),
                     !cell.good   ? "·"
                     : *cell.good ? "✓"
                                  : "✗");
        list.AddText(small, small->FontSize, {x + look.px(16), top + look.px(1)}, packed(ink), cell.word.c_str());
    }
}

void headings(const Look& look) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImFont* small = look.fonts.small;
    const float line = small->FontSize + look.px(1);
    list.AddText(small, small->FontSize, {low.x + look.px(kColumns[0]), low.y}, packed(look.readable(Rule::Naive)),
                 "M n keeps");
    list.AddText(small, small->FontSize, {low.x + look.px(kColumns[2]), low.y}, packed(look.dim), "and beside it");
    for (std::size_t i = 0; i < kHeadings.size(); ++i) {
        const ImVec2 at{low.x + look.px(kColumns[i]), low.y + line};
        list.AddText(small, small->FontSize, at, packed(look.dim), kHeadings[i]);
        ImGui::SetCursorScreenPos(at);
        ImGui::Dummy({small->CalcTextSizeA(small->FontSize, 1e9f, 0, kHeadings[i]).x, look.px(16)});
        tip(look, kAbout[i]);
    }
    ImGui::SetCursorScreenPos({low.x, low.y + line + look.px(18)});
    ImGui::Dummy({0, 0});
}

// What M is, in one line: "M is a reflection and an uneven scale."
std::string what_m_is(const std::vector<MapClassRow>& rows) {
    std::string text;
    for (const MapClassRow& row : rows) {
        if (!row.contains_m) continue;
        text += (text.empty() ? "M is of the class " : ", and of ") + std::string(name(row.map_class));
    }
    return text + ".";
}

void not_affine_remark(const Look& look, const Frame& frame) {
    std::string at_probe;
    for (std::size_t i = 0; frame.probe && frame.probe->truth && i < kRules.size(); ++i) {
        const auto& n = frame.probe->normals[i];
        if (const auto off = n ? angle_degrees(n->xyz, frame.probe->truth->xyz) : std::nullopt)
            at_probe += (at_probe.empty() ? " At the probe " : ", ") + std::string(formula(kRules[i])) + " is off by " +
                        in_degrees(off);
    }
    wrapped(
        look, look.text,
        "M is not affine: what it does to tangents and normals depends on the place, and no 3×3 matrix is right. The "
        "normal is that of the tangent plane’s image." +
            at_probe + (at_probe.empty() ? "" : "."));
}

void how_sure(const Look& look, const MapClaims& c) {
    const auto figure = [&](const char* label, const std::string& value, float at, const char* about) {
        ImGui::SetCursorPosX(at);
        ImGui::BeginGroup();
        dim_text(look, label);
        ImGui::SameLine(0, look.px(6));
        ImGui::TextUnformatted(value.c_str());
        ImGui::EndGroup();
        tip(look, about);
    };
    const float left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    figure("rank", std::to_string(c.rank), left, "How many dimensions M leaves.");
    ImGui::SameLine();
    figure("condition", c.condition ? fixed(c.condition, 2) : "infinite", left + 0.22f * width,
           "σmax/σmin, the largest stretch over the smallest: how much inverting can enlarge rounding errors.");
    ImGui::SameLine();
    figure("digits lost", c.digits_lost ? fixed(c.digits_lost, 1) + " of 16" : "all", left + 0.60f * width,
           "The logarithm of the condition number.");
    std::string sure = "M belongs to a class if it does so to one part in a billion. ";
    if (!c.condition)
        sure =
            "M has no inverse, or is so close to having none that 16 digits cannot tell: nothing can be inverted here.";
    else if (*c.digits_lost > 8.0)
        sure += "M is so badly conditioned that the last digits of (M⁻¹)ᵀ are noise.";
    else
        sure += "The numbers of (M⁻¹)ᵀ are good to " +
                std::to_string(static_cast<int>(15.0 - std::ceil(*c.digits_lost))) + " digits or more.";
    wrapped(look, look.dim, sure);
}

}  // namespace

void draw_maps_tab(const Scene& scene, MapsTab& tab, const SideContext& context) {
    const Look& look = context.look;
    Transform<World, Object> m;
    try {
        m = world_from_object(scene);
    } catch (const InputError& error) {
        return remark(look, look.bad, error.what());
    }
    const int rank = m.normal_matrices_by_rule().rank;
    if (tab.computed_of != m.matrix() || tab.computed_rank != rank) {
        tab.computed_of = m.matrix();
        tab.computed_rank = rank;
        tab.rows = map_classes(m.matrix(), rank);
        tab.claims = claims(m.matrix(), rank);
    }
    wrapped(look, look.text, what_m_is(tab.rows));
    headings(look);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(6), 0));
    for (const MapClassRow& row : tab.rows) table_row(look, row);
    ImGui::PopStyleVar();
    ImGui::Dummy({0, look.px(2)});
    if (!m.affine()) not_affine_remark(look, context.frame);
    if (m.affine() && m.normal_matrices_by_rule().determinant < 0.0) reflection_remark(look);
    if (section(look, "How sure")) how_sure(look, tab.claims);
}

}  // namespace normalscope

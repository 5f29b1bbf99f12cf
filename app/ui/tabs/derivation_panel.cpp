#include "ui/tabs/derivation_panel.h"

#include "core/explain/explanation.h"
#include "ui/kit/widgets.h"

#include <imgui_internal.h>  // whose a key is

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

namespace normalscope {

DerivationPanel::Basis DerivationPanel::basis_of(const Scene& scene, const Frame& frame, float width) const {
    const Transform<World, Object> m = world_from_object(scene);
    const int factors = static_cast<int>(applied_stack(scene).size());
    const std::optional<Probe> probe = frame.probe ? std::optional(frame.probe->object) : std::nullopt;
    Basis basis{m.matrix(), m.normal_matrices_by_rule().rank, factors, notes(scene, m, probe), {}, tangent_, shown_,
                width};
    if (probe) basis.probe = {probe->point.xyz, probe->normal.xyz, probe->tangents[0].xyz, probe->tangents[1].xyz};
    return basis;
}

void DerivationPanel::lay_out(const Look& look, const Scene& scene, const Frame& frame) {
    const float width = width_of_lines(look);
    Basis basis = basis_of(scene, frame, width);
    if (laid_out_for_ == basis) return;
    const Transform<World, Object> m = world_from_object(scene);
    const std::optional<Probe> probe = frame.probe ? std::optional(frame.probe->object) : std::nullopt;
    const Derivation data = derivation(m, basis.factors, with_normal(probe), tangent_);
    passages_ = passages(look, data, shown_, tangent_, width);
    const Meaning by = data.n_world_by == Rule::Cofactor ? Meaning::Cofactor : Meaning::InverseTranspose;
    notes_.clear();
    for (const std::string& note : basis.notes)
        notes_.push_back(paragraph(math_style(look), note, width, Ink::Plain, by));
    laid_out_for_ = std::move(basis);
}

void DerivationPanel::go_to(std::size_t passage) {
    current_ = std::min(passage, passages_.size() - 1);
    scroll_frames_ = 2;
}

void DerivationPanel::header(const Look& look) {
    ImGui::PushFont(look.fonts.title);
    ImGui::TextUnformatted("Why the inverse transpose?");
    ImGui::PopFont();
    if (look.still) return;

    static constexpr std::array<Segment, 2> kNames{
        {{"names", "Every symbol by its name."},
         {"numbers", "Every symbol by the scene's numbers. Click a symbol to switch just that one."}}};
    static constexpr std::array<Segment, 2> kTangents{{{"t₁", "v is the probe's first tangent, or H's first edge."},
                                                       {"t₂", "v is the probe's second tangent, or H's second edge."}}};
    int numbers = shown_.numbers, tangent = static_cast<int>(tangent_);
    ImGui::PushItemWidth(look.px(168));
    if (segmented(look, "##numbers", numbers, kNames)) {
        shown_ = {numbers != 0, {}};
        scroll_frames_ = 2;  // the next frame lays it out, the one after knows how high that is
    }
    ImGui::PopItemWidth();
    ImGui::SameLine(0, look.px(10));
    ImGui::PushItemWidth(look.px(84));
    if (segmented(look, "##tangent", tangent, kTangents)) tangent_ = static_cast<std::size_t>(tangent);
    ImGui::PopItemWidth();
    ImGui::SameLine(0, look.px(10));
    if (accented_button(look, "step by step", stepping_,
                        {ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight() + look.px(2)})) {
        stepping_ = !stepping_;
        go_to(0);
    }
    tip(look, "Uncover one line after another (right arrow).");
    if (stepping_) progress(look);
}

void DerivationPanel::progress(const Look& look) {
    const float side = look.px(27), gap = look.px(6);
    if (icon_button(look, "##back",
                    {.icon = Icon::Left, .about = "Back (left arrow)", .enabled = current_ > 0, .side = 27}))
        go_to(current_ - 1);
    ImGui::SameLine(0, gap);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - side - gap;
    ImGui::Dummy({width, side});
    ImGui::SameLine(0, gap);
    if (icon_button(
            look, "##on",
            {.icon = Icon::Right, .about = "On (right arrow)", .enabled = current_ + 1 < passages_.size(), .side = 27}))
        go_to(current_ + 1);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float count = static_cast<float>(passages_.size()), each = width / count,
                middle = std::round(from.y + side / 2);
    for (std::size_t i = 0; i < passages_.size(); ++i) {
        const float x = from.x + each * static_cast<float>(i);
        list.AddRectFilled({std::round(x) + look.px(1), middle - look.px(2)},
                           {std::round(x + each) - look.px(1), middle + look.px(2)},
                           packed(i <= current_ ? look.accent : look.field), look.px(2));
    }
}

// Wherever one has clicked last; but not while one types, nor before one begins while arrow keys go from button to button.
void DerivationPanel::keys() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.KeyMods || ImGui::IsAnyItemActive()) return;
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
    if (!stepping_ && io.NavVisible) return;
    // The page keys are what presenters' remote controls send.
    constexpr std::array kOn{ImGuiKey_RightArrow, ImGuiKey_DownArrow, ImGuiKey_PageDown};
    constexpr std::array kBack{ImGuiKey_LeftArrow, ImGuiKey_UpArrow, ImGuiKey_PageUp};
    const ImGuiID owner = ImGui::GetID("##by keys");
    const auto pressed = [&](std::span<const ImGuiKey> keys) {
        for (const ImGuiKey key : keys) ImGui::SetKeyOwner(key, owner);
        return std::ranges::any_of(keys, [&](ImGuiKey key) { return ImGui::IsKeyPressed(key, owner); });
    };
    const bool on = pressed(kOn), back = pressed(kBack);
    if (!stepping_) {
        if (!on) return;
        stepping_ = true;
        return go_to(0);
    }
    if (on) go_to(current_ + 1);
    if (back && current_ > 0) go_to(current_ - 1);
    if (pressed(std::array{ImGuiKey_Home})) go_to(0);
    if (pressed(std::array{ImGuiKey_End})) go_to(passages_.size() - 1);
}

std::optional<Highlight> DerivationPanel::highlight_of(const MathBox::Part& part) const {
    if (part.kind != Expression::Kind::Symbol) return std::nullopt;
    const bool tangent = part.symbol == Symbol::VObject || part.symbol == Symbol::VWorld;
    return Highlight{part.symbol, part.meaning == Meaning::Naive, tangent ? tangent_ : 0};
}

void DerivationPanel::part_tip(const Look& look, const MathBox::Part& part) const {
    std::string text;
    if (part.kind == Expression::Kind::Symbol) switch (part.symbol) {
            case Symbol::NObject: text = "the object's own normal, before M"; break;
            case Symbol::VObject: text = "a tangent of the object, before M"; break;
            case Symbol::NWorld:
                text = part.meaning == Meaning::Naive ? "the naive rule's normal" : "the normal in the world";
                break;
            case Symbol::VWorld: text = "the same tangent in the world"; break;
            case Symbol::M3: text = "the upper left 3×3 of M"; break;
            case Symbol::Zero: text = "perpendicular: in the tangent plane"; break;
        }
    const char* const what = part.as_number ? "a click shows its name" : "a click shows its numbers";
    if (part.has_number)
        text += (text.empty() ? "" : "; ") + std::string(what);
    else if (part.kind != Expression::Kind::Symbol)
        text = "has no value here";
    else if (part.symbol != Symbol::Zero)
        text += "; there is none here";
    tip(look, text.c_str());
}

void DerivationPanel::row(const Look& look, const Passage::Row& row, ImVec2 at) {
    const ImVec2 origin{at.x, at.y + row.box.ascent};
    const ImVec2 low{at.x - look.px(3), at.y - look.px(3)},
        high{at.x + row.box.width + look.px(3), at.y + row.box.height() + look.px(3)};
    if (!ImGui::IsRectVisible(low, high)) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto behind = [&](const MathBox::Part& part, const ImVec4& color) {
        list.AddRectFilled({origin.x + part.low.x, origin.y + part.low.y},
                           {origin.x + part.high.x, origin.y + part.high.y}, packed(color), look.px(4));
    };
    const MathBox::Part* under = nullptr;
    if (!row.box.parts.empty()) {
        ImGui::SetCursorScreenPos(low);
        ImGui::PushID(static_cast<int>(row.line));
        const bool clicked = ImGui::InvisibleButton("##line", {high.x - low.x, high.y - low.y});
        ImGui::PopID();
        const ImVec2 pointer = ImGui::GetIO().MousePos;
        if (ImGui::IsItemHovered()) under = part_at(row.box, {pointer.x - origin.x, pointer.y - origin.y});
        if (clicked && under && under->has_number) shown_.toggle(row.line, under->place);
        if (under) {
            part_tip(look, *under);
            pointed_at_ = highlight_of(*under);
        }
    }
    // Lit up: what the pointer is on, here or in the picture, wherever else it stands.
    for (const MathBox::Part& part : row.box.parts) {
        const auto highlight = highlight_of(part);
        if (highlight && (highlight == pointed_at_before_ || highlight == in_picture_))
            behind(part, faded(color_of(look, ink_of(part.meaning)), 0.22f));
    }
    if (under && !highlight_of(*under) && under->has_number) behind(*under, faded(look.dim, 0.16f));
    draw_math(list, look, row.box, origin);
}

void DerivationPanel::passage(const Look& look, std::size_t i, float width) {
    const Passage& passage = passages_[i];
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float gutter = look.px(kGutter), height = height_of(look, passage);
    const ImVec2 end{from.x + width, from.y + height};
    if (stepping_ && i == current_) {
        list.AddRectFilled(from, end, packed(look.card), look.px(6));
        list.AddRectFilled({from.x, from.y + look.px(6)}, {from.x + look.px(3), end.y - look.px(6)},
                           packed(look.accent), look.px(1.5f));
        const float view = ImGui::GetWindowHeight(), top = from.y - ImGui::GetWindowPos().y;
        if (scroll_frames_ > 0)
            height < view ? ImGui::SetScrollFromPosY(top + height / 2, 0.5f) : ImGui::SetScrollFromPosY(top, 0.0f);
        scroll_frames_ = std::max(0, scroll_frames_ - 1);
    }
    ImVec2 at{from.x + gutter + look.px(6), from.y + look.px(kPad)};
    const ImFont* small = look.fonts.small;
    const float size = look.shrink * small->FontSize, ascent = look.shrink * small->Ascent;
    if (passage.title.empty()) {
        const std::string number = std::to_string(i + 1);
        const float number_width = small->CalcTextSizeA(size, 1e9f, 0, number.c_str()).x;
        const float baseline = at.y + passage.rows.front().box.ascent;
        list.AddText(small, size,
                     {std::round(from.x + gutter - look.px(6) - number_width), baseline - std::round(ascent)},
                     packed(look.dim), number.c_str());
    } else {
        list.AddText(look.fonts.strong, look.shrink * look.fonts.strong->FontSize, at, packed(look.text),
                     passage.title.c_str());
        at.y += look.shrink * look.fonts.strong->FontSize + look.px(8);
    }
    for (std::size_t r = 0; r < passage.rows.size(); ++r) {
        at.y += passage.rows[r].above;
        row(look, passage.rows[r], {at.x, at.y});
        // The mark stands beside the reason: the line is true of these numbers, or not.
        if (r == 1 && passage.title.empty()) {
            const bool holds = passage.state == Step::State::Holds, fails = passage.state == Step::State::Fails;
            list.AddText(small, size, {from.x + look.px(7), at.y + passage.rows[r].box.ascent - std::round(ascent)},
                         packed(holds   ? look.good
                                : fails ? look.bad
                                        : look.dim),
                         holds   ? "✓"
                         : fails ? "✗"
                                 : "\u2013");
        }
        at.y += passage.rows[r].box.height();
    }
    ImGui::SetCursorScreenPos(from);
    ImGui::Dummy({width, height});
}

// What is special about this M, before all lines.
void DerivationPanel::draw_notes(const Look& look, float width) {
    if (notes_.empty()) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    list.AddRectFilled(from, {from.x + width, from.y + notes_height(look) - look.px(4)}, packed(look.card), look.px(6));
    float y = from.y + look.px(8);
    for (const MathBox& note : notes_) {
        draw_math(list, look, note, {from.x + look.px(kGutter) + look.px(6), y + note.ascent});
        y += note.height() + look.px(8);
    }
}

void DerivationPanel::draw_lines(const Look& look, float width, float height) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    draw_notes(look, width);
    ImVec2 at{from.x, from.y + notes_height(look)};
    for (std::size_t i = 0; i < lines_shown(); ++i) {
        const float each = height_of(look, passages_[i]);
        if (at.y > from.y && at.y + each > from.y + height) at = {at.x + look.px(column_width()), from.y};
        ImGui::SetCursorScreenPos(at);
        passage(look, i, width);
        at.y += each;
    }
}

void DerivationPanel::draw(const Look& look, const Scene& scene, const Frame& frame,
                           const std::optional<DerivationRoom>& room) {
    pointed_at_before_ = std::exchange(pointed_at_, std::nullopt);
    if (!room || !room->to_all) fit_ = {}, fitted_for_.reset();
    if (!room) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(look.px(this->width()), screen.x), margin = look.px(kMargin),
                bar = ImGui::GetStyle().ScrollbarSize;
    lay_out(look.smaller(fit_.shrink), scene, frame);

    // The arrow keys turn the lines over; otherwise they wander from button to button as everywhere.
    const ImGuiWindowFlags no_keys = stepping_ ? ImGuiWindowFlags_NoNavInputs : 0;
    begin_beside(frame.rect, "##derivation", {screen.x - width, room->top}, {width, screen.y - room->top}, no_keys);
    const ImVec2 low = ImGui::GetWindowPos();
    ImGui::GetWindowDrawList()->AddLine({low.x, low.y}, {low.x, low.y + screen.y}, packed(look.line));

    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(margin, look.px(10)));
    const bool head =
        ImGui::BeginChild("##header", {width, 0}, ImGuiChildFlags_AlwaysUseWindowPadding | ImGuiChildFlags_AutoResizeY,
                          ImGuiWindowFlags_NavFlattened | no_keys);
    ImGui::PopStyleVar();
    if (head) header(look);
    ImGui::EndChild();
    keys();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
    if (room->to_all) fit(look, scene, frame, {screen.x, ImGui::GetContentRegionAvail().y});
    const Look smaller = look.smaller(fit_.shrink);
    lay_out(smaller, scene, frame);

    const float side = room->to_all ? smaller.px(kMargin) : margin - bar;
    const ImGuiWindowFlags scrolling =
        room->to_all ? ImGuiWindowFlags_NoScrollbar : ImGuiWindowFlags_AlwaysVerticalScrollbar;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(side, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    if (ImGui::BeginChild("##lines", {width, 0}, ImGuiChildFlags_AlwaysUseWindowPadding,
                          ImGuiWindowFlags_NavFlattened | scrolling | no_keys)) {
        const ImVec2 inside = ImGui::GetContentRegionAvail();
        room->to_all ? draw_lines(smaller, smaller.px(column_width()) - 2 * side, inside.y)
                     : draw_lines(smaller, inside.x, std::numeric_limits<float>::infinity());
    }
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
    ImGui::End();
}

}  // namespace normalscope

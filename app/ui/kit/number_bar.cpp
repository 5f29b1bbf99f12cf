#include "ui/kit/number_bar.h"

#include "core/base/caught.h"
#include "core/scene/typed_number.h"
#include "ui/kit/number_text.h"
#include "ui/kit/widgets.h"

#include <imgui_internal.h>  // TempInputIsActive: whether a number is being typed

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace normalscope {

namespace {

// Where in its frame a bar runs: between the letter and the number, or where these leave it no room, below them.
struct Track {
    bool strip = false;
    float left = 0.0f, right = 0.0f;  ///< from the frame's left
};
Track track_of(const Look& look, const NumberBar& bar, float width) {
    const float left = std::round(ImGui::CalcTextSize(bar.letter).x) + look.px(18), right = width - look.px(72);
    if (right - left >= look.px(90)) return {false, left, right};
    return {true, look.px(6), width - look.px(6)};
}

void draw_track(const Look& look, double value, const NumberBar& bar, ImVec2 low, ImVec2 high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec4 color = bar.color.value_or(look.accent);
    const auto [strip, left, right] = track_of(look, bar, high.x - low.x);
    const auto x = [&, from = left, to = right](double v) {
        const double t = std::clamp((v - bar.low) / (bar.high - bar.low), 0.0, 1.0);
        return std::round(low.x + from + static_cast<float>(t) * (to - from));
    };
    const float zero = x(bar.zero), at = x(value), half = look.px(1.5f);
    const float top = strip ? high.y - look.px(6) : low.y + look.px(3), bottom = high.y - look.px(strip ? 2 : 3);
    if (!strip) {
        const float middle = std::round((low.y + high.y) / 2);
        list.AddLine({x(bar.low), middle}, {x(bar.high), middle}, packed(faded(look.dim, 0.35f)));
        list.AddLine({zero, top + look.px(2)}, {zero, bottom - look.px(2)}, packed(faded(look.dim, 0.6f)));
    }
    list.AddRectFilled({std::min(zero, at), top}, {std::max(zero, at), bottom}, packed(faded(color, 0.3f)), look.px(2));
    const float more = strip ? look.px(1) : 0.0f;
    list.AddRectFilled({at - half, top - more}, {at + half, bottom + more}, packed(color), half);
}

// Over the frame that Dear ImGui drew: the bar, the letter and the number.
void draw_bar(const Look& look, double value, const NumberBar& bar) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const bool has_track = bar.low < bar.high;
    if (has_track) draw_track(look, value, bar, low, high);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool above = has_track && track_of(look, bar, high.x - low.x).strip;
    const float y = std::round((low.y + high.y - ImGui::GetFontSize()) / 2) - (above ? look.px(2) : 0.0f);
    const ImVec4 ink = bar.color ? look.readable({bar.color->x, bar.color->y, bar.color->z}) : look.dim;
    list.AddText({low.x + look.px(8), y}, packed(ink), bar.letter);
    const std::string text = fixed_unless_small(value, bar.decimals) + bar.unit;
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    list.AddText({high.x - width - look.px(8), y}, packed(look.text), text.c_str());
}

void bar_tip(const Look& look, const NumberBar& bar) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip) || ImGui::IsItemActive()) return;
    std::string text =
        std::string(bar.about) + (*bar.about ? "\n" : "") + "Drag to change" +
        (bar.catches ? "; it catches at 0, ½, 1, 2 and −1 (not with Alt, which is slower)" : " (Alt: slowly)") +
        ". Click to type: 0.5, 1/2, √2, pi/4.";
    if (bar.rest && *bar.letter)
        text += " Click “" + std::string(bar.letter) + "” to set it back to " + brief(*bar.rest) + bar.unit + ".";
    tip(look, text.c_str());
}

// Dear ImGui reads just the 1 of "1/2", and forgets digits where typing is given up.
void read_typed(const Look& look, ImGuiID id, double& value, const NumberBar& bar, double before) {
    const ImGuiInputTextState* state = ImGui::GetInputTextState(id);
    if (!state || state->TextA.empty() || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) {
        value = before;
        return;
    }
    const std::string_view text = state->TextA.Data;
    const std::optional<double> typed = text == state->InitialTextA.Data ? before : typed_number(text);
    value = typed.value_or(before);
    const bool outside = typed && (*typed < bar.range.low || *typed > bar.range.high);
    if (text.empty() || (typed && !outside)) return;
    const std::string why = typed ? "from " + brief(bar.range.low) + " to " + brief(bar.range.high)
                                  : std::string("not yet a number, such as 0.5, 1/2, √2 or pi/4");
    ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + look.px(4)});
    show_tip(look, why.c_str());
}

// The hand goes on while the number is caught: what Dear ImGui makes of a drag starts from what is shown.
double caught_while_dragged(double shown, double dragged, Range range, double reach) {
    static double hand;  // one drags one bar at a time
    if (ImGui::IsItemActivated()) hand = shown;
    hand = std::clamp(hand + dragged - shown, range.low, range.high);
    return ImGui::GetIO().KeyAlt ? hand : caught(hand, reach);
}

// The bar comes next, and has been pressed and let go without a drag, at its letter.
bool clicked_letter(const Look& look, const NumberBar& bar) {
    const ImGuiIO& io = ImGui::GetIO();
    const float end = ImGui::GetCursorScreenPos().x + ImGui::CalcTextSize(bar.letter).x + look.px(14);
    return ImGui::IsMouseReleased(ImGuiMouseButton_Left) && io.MouseClickedPos[0].x < end &&
           io.MouseDragMaxDistanceSqr[0] < look.px(3) * look.px(3);
}

}  // namespace

bool number_bar(const Look& look, const char* id, double& value, const NumberBar& bar) {
    const bool has_bar = bar.low < bar.high;
    const float width = ImGui::CalcItemWidth();
    const double before = value;
    const ImGuiID field = ImGui::GetID(id);
    const bool typing = ImGui::TempInputIsActive(field);
    const bool dragging = !typing && ImGui::GetActiveID() == field;
    // While dragged, the format tells what to round to; when typing begins, it tells how many digits to show.
    const std::string format =
        dragging ? "%." + std::to_string(std::max(0, static_cast<int>(std::lround(-std::log10(bar.step))))) + "f"
                 : "%.6g";
    const Track track = track_of(look, bar, width);
    const double speed =
        has_bar ? (bar.high - bar.low) / std::max(1.0f, track.right - track.left) : bar.step / look.scale;
    const bool inside = has_bar && value >= bar.low && value <= bar.high;
    const double low = inside ? bar.low : bar.range.low, high = inside ? bar.high : bar.range.high;

    const bool resets = bar.rest && dragging && clicked_letter(look, bar);
    if (resets) ImGui::ClearActiveID();  // or a click would begin to type
    // Its own text would have a hyphen for a minus and hang in the middle.
    ImGui::PushStyleColor(ImGuiCol_Text, typing ? look.text : ImVec4(0, 0, 0, 0));
    bool changed = ImGui::DragScalar(id, ImGuiDataType_Double, &value, static_cast<float>(speed), &low, &high,
                                     format.c_str(), ImGuiSliderFlags_None);
    ImGui::PopStyleColor();
    static double before_typing;  // one types into one field at a time
    if (typing) {
        read_typed(look, field, value, bar, before_typing);
        changed = value != before;
        // Dear ImGui selects a word, of which 2.00 has two.
        if (ImGuiInputTextState* state = ImGui::GetInputTextState(field);
            state && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
            state->SelectAll();
    } else if (ImGui::TempInputIsActive(field)) {
        before_typing = before;
    }
    if (bar.catches && has_bar && !typing && ImGui::IsItemActive() && !ImGui::TempInputIsActive(field))
        value = caught_while_dragged(before, value, {low, high}, 4.0 * static_cast<double>(look.scale) * speed);
    if (resets) value = *bar.rest;
    changed |= value != before;
    if (!ImGui::TempInputIsActive(field)) draw_bar(look, value, bar);
    bar_tip(look, bar);
    if (!changed) return false;
    value = std::clamp(value, bar.range.low, bar.range.high) + 0.0;  // + 0: not −0
    return value != before;
}

bool number_bar(const Look& look, const char* id, int& value, const NumberBar& bar) {
    double number = value;
    NumberBar whole = bar;
    whole.step = 1.0;
    whole.decimals = 0;
    if (!number_bar(look, id, number, whole)) return false;
    const int now = static_cast<int>(std::lround(number));
    const bool changed = now != value;
    value = now;
    return changed;
}

void direction_bars(const Look& look, const char* id, double& azimuth, double& elevation,
                    const DirectionBar& azimuth_bar, const DirectionBar& elevation_bar) {
    const float gap = look.px(6), half = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    const auto bar = [&](const char* which, double& degrees, const DirectionBar& text, double most,
                         const Range& range) {
        ImGui::SetNextItemWidth(half);
        number_bar(look, which, degrees,
                   {.letter = text.letter,
                    .low = -most,
                    .high = most,
                    .step = 1,
                    .decimals = 0,
                    .unit = "°",
                    .range = range,
                    .about = text.about,
                    .rest = text.rest});
    };
    ImGui::PushID(id);
    bar("##azimuth", azimuth, azimuth_bar, 180, kDegrees);
    ImGui::SameLine(0, gap);
    bar("##elevation", elevation, elevation_bar, 90, {-90, 90});
    ImGui::PopID();
}

}  // namespace normalscope
